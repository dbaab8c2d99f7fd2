// Solves an island's problem by successive over-relaxation (projected Gauss-Seidel with a factor), as upstream's QuickStep does:
// sweeps over all rows, which are shuffled before every eighth sweep but the first.
//
// Source of the method: Cryer, "The solution of a quadratic programming problem using systematic overrelaxation", 1971.
#pragma once

#include <optional>

#include "dynamics/quick_step/sor/dxParallelSor.h"
#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxSorSolver {
public:
    // The number of sweeps and the factor are the world's. A large island's workers share rows and sweeps.
    explicit dxSorSolver(const dxIslandStep &step) : m_step(step), m_islandWorkers(step.islandWorkers) {}

    // Sets lambda of all rows and problem.accelerations. Overwrites the rows' Jacobians and right-hand sides, and `order`.
    void solve(const dxIslandProblem &problem);

private:
    void prepareRows(const dxIslandProblem &problem) const;
    void sweep(const dxIslandProblem &problem, unsigned times);
    unsigned partsOf(const dxIslandProblem &problem) const;

    const dxIslandStep &m_step;
    dxLargeIslandWorkers *m_islandWorkers;         // null: the caller sweeps alone
    std::optional<dxParallelSor::Lease> m_shared;  // their sweeps, from the first one on
};
