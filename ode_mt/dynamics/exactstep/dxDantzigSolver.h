// Dantzig's algorithm (ode_mt/dynamics/exactstep/dantzig), with upstream's bits.
#pragma once

#include "dynamics/exactstep/dxExactSolver.h"

struct dxIslandTeam;

class dxDantzigSolver final : public dxExactSolver {
public:
    // `team`: workers for large problems; null: the calling thread alone.
    explicit dxDantzigSolver(dxIslandTeam *team) : m_team(team) {}

    void solve(const dxExactProblem &problem, dxWorldProcessMemArena &arena) override;

private:
    dxIslandTeam *const m_team;
};
