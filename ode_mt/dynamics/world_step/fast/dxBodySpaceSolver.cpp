#include "dynamics/world_step/fast/dxBodySpaceSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/world_step/fast/dxResidual.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The residual from which on another solver is asked, as part of the largest b and of the largest sum: rows that contradict one another
// have forces of b/c, whose sums are rounded to more than the rest.
constexpr dxResidualBound kMaxResidual = {1e-9, 64 * std::numeric_limits<double>::epsilon()};

// The least c of regularised rows, as part of the diagonal. At first half of the digits: a solution loses as much to it as rounding takes from forces
// of b/c. Then it shrinks from correction to correction. An interior point may not get as far as forces of 1e8 b: softer rows have smaller ones.
constexpr double kRegularisation = 1e-8, kNextRegularisation = 0.1, kSofterRegularisation = 100, kMinRegularisation = 1e-11, kMaxRegularisation = 1;

// c of rows on bodies that no force moves.
constexpr double kSoftnessOfNothing = 1;

constexpr unsigned kMaxCorrections = 8;

// The part of the energy from which on a correction does not count.
constexpr double kWorthwhile = 0.9;

}  // namespace

bool dxBodySpaceSolver::read(const dxWorldStepProblem &rows, double stepSize, dxTaskRunner &runner) {
    m_residual = kInfinity;
    m_source = &rows;
    if (!m_rows.gather(rows, stepSize)) return false;
    m_phases.reserve(runner.workers());
    m_interior.begin(m_rows.problem(), m_rows.order(), m_phases, runner.workers());
    return true;
}

bool dxBodySpaceSolver::solve(dxTaskRunner &runner) {
    m_residual = kInfinity;
    m_phases.run(dxParallelStage::BodySpace, runner, [this] { solveBoth(); });
    if (m_residual == kInfinity) return false;
    const dxInteriorPoint::Scale found = scale();
    return dxIsGoodResidual(kMaxResidual, m_residual, found.b, found.sum, *m_source, m_rows.motions().data()) && isAnswer(m_residual);
}

bool dxBodySpaceSolver::isAnswer(double residual) const {
    const dxBodySpaceProblem &problem = m_rows.problem();
    double softSum = 0;
    for (unsigned i = 0; i < problem.rowCount; ++i)
        if (dxBodySpaceProblem::isSoft(problem.c[i], problem.diagonal[i]))
            softSum = std::max(softSum, problem.diagonal[i] * std::fabs(m_interior.x()[i]));
    return dxIsAnswer(residual, scale().b, softSum, *m_source, m_rows.motions().data());
}

bool dxBodySpaceSolver::regularise(dxTaskRunner &runner) {
    m_residual = kInfinity;
    m_phases.run(dxParallelStage::BodySpace, runner, [this] { solveRegularised(); });
    return m_residual < kInfinity;
}

// Proximal point method: each problem has the last one's forces for those from which it goes as little as it can. What rows can do is soon done, and
// what they contradict one another in adds to the forces each time and gains nothing.
void dxBodySpaceSolver::solveRegularised() {
    const std::vector<double> b = m_rows.problem().b, c = m_rows.problem().c;
    std::vector<double> x(b.size()), best;
    double least = kInfinity, part = kRegularisation;
    for (unsigned i = 0; i < kMaxCorrections && part >= kMinRegularisation && part <= kMaxRegularisation; ++i) {
        if (!solveSoftened(part, b, c, x)) {
            if (least < kInfinity) break;
            part *= kSofterRegularisation;
            continue;
        }
        part *= kNextRegularisation;
        const double energy = m_interior.energyOf(x);
        if (!(energy < kWorthwhile * least)) break;
        least = energy;
        best = x;
        if (isAnswer(m_interior.residualOf(x))) break;
    }
    m_residual = kInfinity;
    if (least == kInfinity) return;
    m_energy = least;
    m_interior.take(best);
    m_residual = m_interior.residualOf(best);
}

// Solves the problem with c of at least `part` of the diagonal, beginning at the forces x. Returns false where that fails, otherwise writes x.
bool dxBodySpaceSolver::solveSoftened(double part, const std::vector<double> &b, const std::vector<double> &c, std::vector<double> &x) {
    dxBodySpaceProblem &problem = m_rows.problem();
    soften(part, b, c, x);
    solveBoth();
    problem.b = b;
    problem.c = c;
    if (m_residual == kInfinity) return false;
    x = m_interior.x();
    return true;
}

// b gets what c takes from the forces x.
void dxBodySpaceSolver::soften(double part, const std::vector<double> &b, const std::vector<double> &c, const std::vector<double> &x) {
    dxBodySpaceProblem &problem = m_rows.problem();
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        const double least = problem.diagonal[i] > 0 ? part * problem.diagonal[i] : kSoftnessOfNothing;
        problem.c[i] = std::max(c[i], least);
        problem.b[i] = b[i] + (problem.c[i] - c[i]) * x[i];
    }
}

void dxBodySpaceSolver::solveBoth() {
    limitRows();
    m_residual = m_interior.solve();
    if (m_residual < kInfinity && limitFriction()) m_residual = std::max(m_residual, m_interior.solve());
}

// Friction rows may not move yet.
void dxBodySpaceSolver::limitRows() {
    const dxBodySpaceProblem &problem = m_rows.problem();
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        m_interior.low()[i] = problem.isFriction(i) ? 0 : problem.lo[i];
        m_interior.high()[i] = problem.isFriction(i) ? 0 : problem.hi[i];
    }
}

// An infinite coefficient allows any force, as long as the normal has one. Returns whether a friction row may move.
bool dxBodySpaceSolver::limitFriction() {
    const dxBodySpaceProblem &problem = m_rows.problem();
    bool mayAnyMove = false;
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        if (!problem.isFriction(i)) continue;
        const double normal = m_interior.x()[problem.normalOf[i]];
        const double limit = normal == 0 ? 0 : std::fabs(problem.hi[i] * normal);
        m_interior.low()[i] = -limit;
        m_interior.high()[i] = limit;
        mayAnyMove = mayAnyMove || limit > 0;
    }
    return mayAnyMove;
}

double dxBodySpaceSolver::residualOf(const dxWorldStepProblem &rows) {
    std::vector<double> x;
    m_rows.readForces(rows, x);
    return m_interior.residualOf(x);
}

double dxBodySpaceSolver::energyOf(const dxWorldStepProblem &rows) {
    std::vector<double> x;
    m_rows.readForces(rows, x);
    return m_interior.energyOf(x);
}
