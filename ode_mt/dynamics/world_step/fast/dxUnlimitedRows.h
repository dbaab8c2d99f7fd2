// Solves an island none of whose rows has limits (chains, nets, hanging loads): one linear system, eliminated joint by joint
// (dxUnlimitedSystem.h). It is what dxReducedLcp does for such islands, in a third of the time.
//
// Threading: one island, one thread. Memory is kept from island to island, and the structure of the last one: where joints hold the same
// bodies by as many rows, as in the next step of a chain, nothing is ordered again. Numbers are never kept, so that bits do not depend on
// what was solved before.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxUnlimitedSystem.h"

struct dxWorldStepProblem;
struct dxIslandStep;

class dxUnlimitedRows {
public:
    // Requires rows, read, all without limits. Returns whether x was found and written, to a residual that rounding explains; else nothing
    // is changed: rows repeat one another, or numbers are not finite.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem);

    // The same for an island of the last one's structure; returns false for any other. Elimination was the cheapest method for that
    // structure, so it is for this one.
    bool solveKnown(const dxIslandStep &step, const dxWorldStepProblem &problem);

    // After either: adds J' x to the bodies' accumulators. Returns false where a joint has feedback, and does nothing.
    bool push(const dxWorldStepProblem &problem) const;

private:
    bool solveOrdered(const dxIslandStep &step, const dxWorldStepProblem &problem);
    bool isOrdered(const dxWorldStepProblem &problem) const;
    void order(const dxWorldStepProblem &problem);
    void pairSides(unsigned bodyCount);
    void takeMemory();
    bool readRows(const dxWorldStepProblem &problem);
    void findMotions(const dxWorldStepProblem &problem, double stepSize);
    void findAccelerations(const dxWorldStepProblem &problem);
    bool isGood(const dxWorldStepProblem &problem);
    void writeForces(const dxWorldStepProblem &problem);

    dxUnlimitedSystem m_system;
    std::vector<dxUnlimitedJoint> m_joints;  // in the island's order
    unsigned m_bodyCount = 0;                // some may have no rows; 0: no structure
    std::vector<std::pair<unsigned, unsigned>> m_edges, m_sides;  // pairs of joints, and of joints' sides, on one body
    std::vector<unsigned> m_first, m_next;   // lists of joints' sides: by body, by side
    std::vector<std::pair<unsigned, dxUnlimitedSystem::Pair>> m_blockPairs;
    std::vector<dxInverseMass> m_inverseMasses;
    dxBodyVectors m_motions, m_bodyForces, m_accelerations;  // by body
};
