#include "dynamics/world_step/fast/dxInteriorPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/world_step/fast/dxKktResidual.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr unsigned kMaxSteps = 100;

// Between 0.3 and 3 the number of steps is the same within a tenth; below, it grows.
constexpr double kStart = 3;

// How much of the way to the nearest limit a step goes.
constexpr double kMaxAdvance = 0.995;

// Parts of the first gap at which the rows' states are guessed and refined: the first one, and each next one of the last.
constexpr double kFirstGuess = 1e-8, kNextGuess = 1e-3, kLastGuess = 1e-26;

// The residual that is good enough, as part of the largest b and of the largest sum.
constexpr double kGoodResidual = 1e-12, kGoodRounding = 1e-15;

// The part of c times a distance that a multiplier is below where the row ends away from its limit.
constexpr double kSurelyFree = 0.1;

// The residual that is as small as it gets, as part of the largest b and sum.
constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();

}  // namespace

void dxInteriorPoint::begin(const dxDirectProblem &problem, const dxEliminationOrder &order, dxPhaseRunner &phases, unsigned threads) {
    m_problem = &problem;
    m_system.begin(problem, order, phases, threads);
    m_refinement.begin(problem);
    m_best.resize(m_system.paddedRows());
    m_state.resize(m_system.paddedRows());
    m_sums.resize(m_system.rowChunks());
    m_steps.resize(m_system.rowChunks());
    low().resize(problem.rowCount);
    high().resize(problem.rowCount);
}

// Rows start as far from their limits as the largest b would push one, and in the middle between two.
void dxInteriorPoint::start() {
    const dxDirectProblem &problem = *m_problem;
    double scale = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i)
        if (problem.diagonal[i] > 0) scale = std::max(scale, std::fabs(problem.b[i]) / std::sqrt(problem.diagonal[i]));
    scale = scale > 0 ? kStart * scale : 1;
    m_limits = 0;
    m_rows.resize(problem.rowCount, m_system.paddedRows());
    for (unsigned i = 0; i < problem.rowCount; ++i) start(i, scale);
}

// `scale`: in units in which each row's diagonal is 1.
void dxInteriorPoint::start(unsigned i, double scale) {
    const double root = std::sqrt(m_problem->diagonal[i] > 0 ? m_problem->diagonal[i] : 1.0);
    const double low = m_rows.low[i], high = m_rows.high[i];
    const bool isFixed = low == high, hasLow = low > -kInfinity, hasHigh = high < kInfinity;
    m_rows.x[i] = isFixed             ? low
                  : hasLow && hasHigh ? low + (high - low) / 2
                  : hasLow            ? low + scale / root
                  : hasHigh           ? high - scale / root
                                      : 0;
    m_rows.toLow[i] = hasLow && !isFixed ? m_rows.x[i] - low : kFarLimit;
    m_rows.toHigh[i] = hasHigh && !isFixed ? high - m_rows.x[i] : kFarLimit;
    m_rows.pullLow[i] = hasLow && !isFixed ? std::min(scale * scale / m_rows.toLow[i], scale * root) : 0;
    m_rows.pullHigh[i] = hasHigh && !isFixed ? std::min(scale * scale / m_rows.toHigh[i], scale * root) : 0;
    m_limits += (m_rows.pullLow[i] > 0) + (m_rows.pullHigh[i] > 0);
    m_rows.dx[i] = m_rows.dPullLow[i] = m_rows.dPullHigh[i] = 0;
    m_rows.b[i] = m_problem->b[i];
    m_rows.c[i] = m_problem->c[i];
    m_rows.softness[i] = m_problem->softnessOf(i);
}

// Goes so far along the step, and finds the gap there.
void dxInteriorPoint::advance(double length) {
    m_system.forRows([&](const Rows &rows, unsigned chunk) {
        m_sums[chunk] = dxInteriorLoops::advance(m_rows, rows.begin, rows.end, length);
    });
    double sum = 0;
    for (const double part : m_sums) sum += part;
    m_gap = m_limits > 0 ? sum / m_limits : 0;
}

// Calls findPart(rows) for all chunks of rows.
template <class FindPart>
dxInteriorLoops::Step dxInteriorPoint::findStep(const FindPart &findPart) {
    m_system.forRows([&](const Rows &rows, unsigned chunk) { m_steps[chunk] = findPart(rows); });
    dxInteriorLoops::Step step;
    for (const dxInteriorLoops::Step &part : m_steps) step.add(part);
    return step;
}

// How much of a step may be taken.
double dxInteriorPoint::lengthOf(const dxInteriorLoops::Step &step) { return step.largestLoss > 1 ? 1 / step.largestLoss : 1; }

// A row ends at a limit if its distance is small beside the multiplier, in units of its diagonal, and away from it if the multiplier
// is small beside the distance, in units of its c. In between, the last step decides: it brings a row that ends there
// nearer to its limit by a larger part than it makes its multiplier smaller.
void dxInteriorPoint::guessStates() {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double diagonal = m_problem->diagonal[i], c = m_problem->c[i];
        const auto isAt = [diagonal, c](double distance, double change, double pull, double pullChange) {
            if (pull == 0) return false;
            if (pull > diagonal * distance) return true;
            if (pull < kSurelyFree * c * distance) return false;
            return change / distance < pullChange / pull;
        };
        m_state[i] = dxRowState::Free;
        m_best[i] = std::clamp(m_rows.x[i], m_rows.low[i], m_rows.high[i]);
        if (m_rows.low[i] == m_rows.high[i] || isAt(m_rows.toLow[i], m_rows.dx[i], m_rows.pullLow[i], m_rows.dPullLow[i])) {
            m_state[i] = dxRowState::AtLow;
            m_best[i] = m_rows.low[i];
        } else if (isAt(m_rows.toHigh[i], -m_rows.dx[i], m_rows.pullHigh[i], m_rows.dPullHigh[i])) {
            m_state[i] = dxRowState::AtHigh;
            m_best[i] = m_rows.high[i];
        }
    }
}

bool dxInteriorPoint::iterate() {
    m_system.findMotion(m_rows.x);
    m_system.forRows([&](const Rows &rows, unsigned) {
        dxInteriorLoops::prepare(m_rows, rows.begin, rows.end, m_system.changeByMotion(rows), m_system.weight(), m_system.scaled());
    });
    if (!m_system.factorise()) return false;
    const double target = predict();
    m_system.forRows([&](const Rows &rows, unsigned) {
        dxInteriorLoops::correct(m_rows, rows.begin, rows.end, target, m_system.weight(), m_system.scaled());
    });
    m_system.solveBodies();
    const double full = lengthOf(findStep([&](const Rows &rows) {
        return dxInteriorLoops::finish(m_rows, rows.begin, rows.end, m_system.changeBySolution(rows), m_system.weight());
    }));
    const double length = full < 1 ? kMaxAdvance * full : kMaxAdvance;
    if (!std::isfinite(length)) return false;
    advance(length);
    return true;
}

// The step to a target of 0. Returns the target of the corrected one. The gap after a part of this step is (1 - part) of the gap, and the
// square of the part times the mean energy.
double dxInteriorPoint::predict() {
    m_system.solveBodies();
    const dxInteriorLoops::Step step = findStep([&](const Rows &rows) {
        return dxInteriorLoops::predict(m_rows, rows.begin, rows.end, m_system.changeBySolution(rows), m_system.weight());
    });
    if (!(m_gap > 0)) return 0;
    const double length = lengthOf(step), after = (1 - length) * m_gap + length * length * step.energy / m_limits;
    const double part = std::max(after / m_gap, 0.0);
    return part * part * part * m_gap;
}

double dxInteriorPoint::solve() {
    start();
    advance(0);
    const double firstGap = m_gap;
    double residual = kInfinity;
    m_found.clear();
    double guess = m_limits > 0 ? kFirstGuess : 1;
    for (unsigned i = 0; i < kMaxSteps; ++i) {
        if (m_gap <= guess * firstGap) {
            guessStates();
            const Scale expected = scaleOf(m_best);
            const double rounding = kRounding * (expected.b + expected.sum);
            const double now = m_refinement.refine(m_system, m_rows.low, m_rows.high, rounding, m_state, m_best);
            if (now < residual) {
                residual = now;
                m_found = m_best;
            }
            const Scale scale = scaleOf(m_best);
            if (residual <= kGoodResidual * scale.b + kGoodRounding * scale.sum || m_gap <= kLastGuess * firstGap) break;
            guess = std::min(guess, m_gap / firstGap) * kNextGuess;
        }
        if (!iterate()) break;
    }
    if (residual < kInfinity) m_rows.x = m_found;
    return residual;
}

dxInteriorPoint::Scale dxInteriorPoint::scaleOf(const std::vector<double> &x) const {
    Scale scale{0, 0};
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        scale.b = std::max(scale.b, std::fabs(m_problem->b[i]));
        scale.sum = std::max(scale.sum, m_problem->diagonal[i] * std::fabs(x[i]));
    }
    return scale;
}

// s of it, too.
void dxInteriorPoint::snapToLimits(std::vector<double> &x) {
    for (unsigned i = 0; i < m_problem->rowCount; ++i) x[i] = dxSnapToLimit(x[i], m_rows.low[i], m_rows.high[i]);
    m_system.findResidual(x, m_rows.s);
}

double dxInteriorPoint::residualOf(std::vector<double> &x) {
    snapToLimits(x);
    return dxWorstKktResidual(x, m_rows.s, m_rows.low, m_rows.high);
}

double dxInteriorPoint::energyOf(std::vector<double> &x) {
    snapToLimits(x);
    double energy = 0;
    for (unsigned i = 0; i < m_problem->rowCount; ++i) {
        const double unit = m_problem->diagonal[i] + m_problem->c[i];
        if (unit == 0) continue;  // no force changes anything in this row
        const double residual = dxKktResidual(x[i], -m_rows.s[i], m_rows.low[i], m_rows.high[i]);
        energy += residual * residual / unit + m_rows.s[i] * 0;
    }
    return std::isfinite(energy) ? energy : kInfinity;
}
