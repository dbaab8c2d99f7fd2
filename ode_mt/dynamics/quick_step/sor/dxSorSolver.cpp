#include "dynamics/quick_step/sor/dxSorSolver.h"

#include <algorithm>
#include <new>

#include "dynamics/quick_step/sor/dxSorOrder.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

namespace {

using Row = dxConstraintRow;

constexpr std::size_t kRowsPerJob = 256;

void prepareRow(const dxIslandProblem &problem, Row &row, dReal factor) {
    constexpr int kJacobianOf[2] = {Row::kBody1, Row::kBody2};
    const int bodies = row.hasSecondBody() ? 2 : 1;
    dReal freeAcceleration = 0;  // J -(v / h + inv(M) f)
    dReal diagonal = 0;          // J inv(M) J'
    for (int which = 0; which < bodies; ++which) {
        const dReal *const jacobian = row.jacobian + kJacobianOf[which];
        const dReal *const acceleration = problem.accelerationOf(row.body[which]);
        for (int i = 0; i < 6; ++i) freeAcceleration += jacobian[i] * acceleration[i];
        dReal *const impulse = which == 0 ? row.impulseOn1 : row.impulseOn2;
        problem.bodies[row.body[which]].respond(jacobian, impulse);
        for (int i = 0; i < 6; ++i) diagonal += impulse[i] * jacobian[i];
    }
    const dReal cfm = row.jacobian[Row::kCfm], scale = factor / (diagonal + cfm);
    row.jacobian[Row::kRhs] = (row.jacobian[Row::kRhs] + freeAcceleration) * scale;
    row.jacobian[Row::kCfm] = cfm * scale;
    for (int which = 0; which < bodies; ++which)
        for (int i = 0; i < 6; ++i) row.jacobian[kJacobianOf[which] + i] *= scale;
}

}  // namespace

void dxSorSolver::solve(const dxIslandProblem &problem) {
    prepareRows(problem);
    std::fill_n(problem.accelerations, problem.bodyCount, dxSpatialMotion());
    unsigned left = static_cast<unsigned>(m_step.world->qs.num_iterations);
    for (unsigned shuffles = 0; left != 0; ++shuffles) {
        if (shuffles == 0) dxScheduleSor(problem);  // the results of dxOrderRows
        if (shuffles == 1) dxOrderRows(problem);
        if (shuffles > 0) dxShuffleRows(problem.order, problem.rowCount);
        const unsigned times = std::min(left, kShuffleInterval);
        sweep(problem, times);
        left -= times;
    }
}

// Completes right-hand sides, finds what each row does to its bodies, and scales rows by the factor over the diagonal.
void dxSorSolver::prepareRows(const dxIslandProblem &problem) const {
    const dReal factor = m_step.world->qs.w;
    m_step.runner().forChunks(dxParallelStage::Rows, problem.rowCount, kRowsPerJob,
                              [&](std::size_t begin, std::size_t end, unsigned) {
                                  for (std::size_t row = begin; row < end; ++row) prepareRow(problem, problem.rows[row], factor);
                              });
}

void dxSorSolver::sweep(const dxIslandProblem &problem, unsigned times) {
    const unsigned parts = partsOf(problem);
    if (parts >= 2) {
        dxBody *const *const bodies = m_step.island.bodies;
        try {
            if (!m_shared)
                (*m_shared.emplace(dxParallelSor::pool())).begin(problem, parts, [bodies](std::size_t i) { return bodies[i]->posr.pos; });
            (**m_shared).sweep(problem, problem.order, times, *m_islandWorkers->runner);
            return;
        } catch (const std::bad_alloc &) {  // while planning, before which nothing is swept
            m_islandWorkers = nullptr;
        }
    }
    for (unsigned i = 0; i < times; ++i) dxSorSweep(problem, problem.order, problem.isLarge());
}

// Below two parts the caller sweeps alone.
unsigned dxSorSolver::partsOf(const dxIslandProblem &problem) const {
    if (m_islandWorkers == nullptr) return 1;
    return std::min(m_islandWorkers->runner->workers(), problem.rowCount / dxParallelSor::kMinRows);
}
