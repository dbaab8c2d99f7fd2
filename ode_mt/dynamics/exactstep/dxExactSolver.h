// What solves an island's problem: finds x, the forces of its rows.
#pragma once

struct dxExactProblem;
class dxWorldProcessMemArena;

class dxExactSolver {
public:
    // Requires rows. Writes x into problem.pairsBX; A, b and the limits of friction rows may be written over. What is taken of
    // the arena is given back, and is no more than dxEstimateSolveLCPMemoryReq says.
    virtual void solve(const dxExactProblem &problem, dxWorldProcessMemArena &arena) = 0;

protected:
    ~dxExactSolver() = default;
};
