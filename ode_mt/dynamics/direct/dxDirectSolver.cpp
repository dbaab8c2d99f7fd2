#include "dynamics/direct/dxDirectSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/direct/dxBodyMotions.h"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The residual from which on another solver is asked, as part of the largest b and of the largest sum: rows that contradict one another
// have forces of b/c, whose sums are rounded to more than the rest.
constexpr dxResidualBound kMaxResidual = {1e-9, 64 * std::numeric_limits<double>::epsilon()};

}  // namespace

bool dxDirectSolver::solve(const dxExactProblem &rows, double stepSize, dxTaskRunner &runner) {
    m_residual = kInfinity;
    if (!m_rows.gather(rows, stepSize)) return false;
    m_phases.reserve(runner.workers());
    m_interior.begin(m_rows.problem(), m_rows.order(), m_phases, runner.workers());
    m_phases.run(dxParallelStage::BodySpace, runner, [this] { solveBoth(); });
    if (m_residual == kInfinity) return false;
    const dxInteriorPoint::Scale found = scale();
    return dxIsGoodResidual(kMaxResidual, m_residual, found.b, found.sum, rows, m_rows.motions());
}

void dxDirectSolver::solveBoth() {
    limitRows();
    m_residual = m_interior.solve();
    if (m_residual < kInfinity && limitFriction()) m_residual = std::max(m_residual, m_interior.solve());
}

// Friction rows may not move yet.
void dxDirectSolver::limitRows() {
    const dxDirectProblem &problem = m_rows.problem();
    for (unsigned i = 0; i < problem.rowCount; ++i) {
        m_interior.low()[i] = problem.isFriction(i) ? 0 : problem.lo[i];
        m_interior.high()[i] = problem.isFriction(i) ? 0 : problem.hi[i];
    }
}

// An infinite coefficient allows any force, as long as the normal has one. Returns whether a friction row may move.
bool dxDirectSolver::limitFriction() {
    const dxDirectProblem &problem = m_rows.problem();
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

double dxDirectSolver::residualOf(const dxExactProblem &rows) {
    std::vector<double> x;
    m_rows.readForces(rows, x);
    return m_interior.residualOf(x);
}
