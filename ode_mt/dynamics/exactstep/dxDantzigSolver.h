// Dantzig's algorithm (ode_mt/dynamics/exactstep/dantzig), with upstream's bits.
#pragma once

#include "dynamics/exactstep/dxExactSolver.h"

struct dxLargeIslandWorkers;

class dxDantzigSolver final : public dxExactSolver {
public:
    // `islandWorkers`: workers for large problems; null: the calling thread alone.
    explicit dxDantzigSolver(dxLargeIslandWorkers *islandWorkers) : m_islandWorkers(islandWorkers) {}

    void solve(const dxExactProblem &problem, dxWorldProcessMemArena &arena) override;

private:
    dxLargeIslandWorkers *const m_islandWorkers;
};
