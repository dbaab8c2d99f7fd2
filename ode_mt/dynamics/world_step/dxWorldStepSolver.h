// What solves an island's problem: finds x, the forces of its rows.
#pragma once

struct dxWorldStepProblem;
struct dxIslandStep;

class dxWorldStepSolver {
public:
    // Requires rows, read. Writes x into problem.pairsBX; b and the limits of friction rows may be written over. What is taken of
    // the step's arena is given back. Returns whether J' x has been added to the bodies' accumulators, too, which is left to
    // dxApplyResults otherwise, as it always is where a joint has feedback.
    virtual bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) = 0;

protected:
    ~dxWorldStepSolver() = default;
};
