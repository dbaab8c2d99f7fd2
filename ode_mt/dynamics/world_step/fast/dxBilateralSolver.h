// Solves an island all of whose rows are bilateral (chains, nets, hanging loads): one linear system, eliminated joint by joint
// (dxBilateralSystem.h). dxEliminatedLcp does the same for such islands in three times the time: whole frames of chain:250 take 1.5 times as long
// with it, dWorldStep 1.8 to 2.5 times, which is why there are both.
//
// Threading: one island, one thread, or the workers of a large island. Memory is kept from island to island, and the structure of the last
// one: where joints hold the same bodies by as many rows, as in the next step of a chain, nothing is ordered again. Numbers are never kept,
// so that bits do not depend on what was solved before.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxBilateralSystem.h"

struct dxWorldStepProblem;
struct dxIslandStep;

class dxBilateralSolver {
public:
    // Requires rows, read, all bilateral. Returns whether x was found and written, to a residual that rounding explains; else nothing
    // is changed: rows repeat one another, or numbers are not finite.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem);

    // The same for an island of the last one's structure; returns false for any other. Elimination was the cheapest method for that
    // structure, so it is for this one.
    bool solveKnown(const dxIslandStep &step, const dxWorldStepProblem &problem);

    // After either: adds J' x to the bodies' accumulators. Returns false where a joint has feedback, and does nothing.
    bool applyForces(const dxWorldStepProblem &problem) const;

private:
    bool solveOrdered(const dxIslandStep &step, const dxWorldStepProblem &problem);
    bool isOrdered(const dxWorldStepProblem &problem) const;
    void order(const dxWorldStepProblem &problem);
    void pairSides(unsigned bodyCount);
    bool readRows(const dxWorldStepProblem &problem);
    void findAccelerations(const dxWorldStepProblem &problem);
    bool isGood(const dxWorldStepProblem &problem);
    void writeForces(const dxWorldStepProblem &problem);

    dxBilateralSystem m_system;
    std::vector<dxBilateralJoint> m_joints;  // in the island's order
    unsigned m_bodyCount = 0;                // some may have no rows; 0: no structure
    std::vector<std::pair<unsigned, unsigned>> m_edges, m_sides;  // pairs of joints, and of joints' sides, on one body
    std::vector<unsigned> m_first, m_next;   // lists of joints' sides: by body, by side
    std::vector<std::pair<unsigned, dxBilateralSystem::Pair>> m_blockPairs;
    std::vector<dxInverseMass> m_inverseMasses;
    dxBodyVectors m_motions, m_bodyForces, m_accelerations;  // by body
};
