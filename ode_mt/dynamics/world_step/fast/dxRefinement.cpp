#include "dynamics/world_step/fast/dxRefinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr unsigned kMaxCorrections = 12;

// Corrections in a row that do not halve the residual before it counts as found.
constexpr unsigned kMaxStalled = 2;

// Rows that change sides at once. More mean that the states were not known yet.
constexpr unsigned kMaxChanges = 20;

// w of the wrong sign, as part of the residual, that sets a row free.
constexpr double kReleaseTolerance = 1e-3;

}  // namespace

void dxRefinement::begin(const dxBodySpaceProblem &problem) {
    m_problem = &problem;
    const unsigned rows = dxProblemChunks::padded(problem.rowCount);
    for (std::vector<double> *array : {&m_s, &m_dx, &m_best}) array->assign(rows, 0);
    m_d.assign(rows, kInfinity);
}

unsigned dxRefinement::updateStates(const std::vector<double> &low, const std::vector<double> &high, const std::vector<double> &x,
                                    double tolerance, std::vector<dxRowState> &state) const {
    unsigned changes = 0;
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        dxRowState now = dxRowState::Free;
        if (low[i] == high[i] || (x[i] <= low[i] && m_s[i] <= tolerance))
            now = dxRowState::AtLow;
        else if (x[i] >= high[i] && m_s[i] >= -tolerance)
            now = dxRowState::AtHigh;
        changes += now != state[i];
        state[i] = now;
    }
    return changes;
}

bool dxRefinement::factorise(dxNormalEquations &system, const std::vector<dxRowState> &state) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i)
        m_d[i] = state[i] == dxRowState::Free ? m_problem->softnessOf(i) : kInfinity;
    return system.factorise(m_d);
}

double dxRefinement::refine(dxNormalEquations &system, const std::vector<double> &low, const std::vector<double> &high,
                            double enough, std::vector<dxRowState> &state, std::vector<double> &x) {
    double best = kInfinity;
    unsigned stalled = 0;
    bool isFactored = false;
    for (unsigned i = 0; i < kMaxCorrections; ++i) {
        system.findResidual(x, m_s);
        const double worst = dxWorstKktResidual(x, m_s, low, high);
        if (worst == kInfinity) break;
        stalled = worst < best / 2 ? 0 : stalled + 1;
        if (worst < best) {
            best = worst;
            m_best = x;
        }
        const unsigned changes = i > 0 ? updateStates(low, high, x, kReleaseTolerance * worst, state) : 0;
        if (worst <= enough || stalled >= kMaxStalled || changes > kMaxChanges) break;
        if (!isFactored || changes > 0) {
            isFactored = factorise(system, state);
            if (!isFactored) break;
        }
        system.solve(m_s, m_dx);
        for (unsigned row = 0; row < m_problem->rowCount; ++row)
            if (state[row] == dxRowState::Free) x[row] = std::clamp(x[row] + m_dx[row], low[row], high[row]);
    }
    if (best < kInfinity) x = m_best;
    return best;
}
