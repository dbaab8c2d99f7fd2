// Solves an island's problem with its bilateral rows eliminated first (dxRowBlocks.h): Dantzig's algorithm then has the unilateral rows
// alone, and does not carry the others through each of its pivots. The solution is the same; so are the two problems in
// sequence (docs/fast.md), since friction rows and their normals have limits.
//
// Threading: one island, one thread. Memory is kept from island to island; the process keeps as many as islands are solved at the same
// time. Nothing is kept that counts but the elimination order, which depends on the joints' graph alone.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxRowBlocks.h"

struct dxWorldStepProblem;
struct dxIslandStep;

class dxEliminatedLcp {
public:
    // Requires rows, read. Returns whether x was found and written, to a residual that rounding explains; else nothing is changed: rows
    // repeat or contradict one another, Dantzig's algorithm gave up, or numbers are not finite.
    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem);

private:
    bool listParts(const dxWorldStepProblem &problem);
    void addPart(const dxWorldStepProblem &problem, unsigned joint, unsigned begin, unsigned end, bool isUnilateral);
    void pairParts(const dxWorldStepProblem &problem);
    void orderJoints();
    void shapeBlocks();
    bool fillRightSide(const dxWorldStepProblem &problem);
    void makeMatrix(const dxWorldStepProblem &problem, double stepSize);
    bool solveUnilateralRows(const dxIslandStep &step, const dxWorldStepProblem &problem);
    void findForces();
    bool isContradictory(const dxWorldStepProblem &problem, double largestB, double largestSum) const;
    bool isGood(const dxWorldStepProblem &problem);
    void writeForces(const dxWorldStepProblem &problem) const;

    dxRowBlocks m_blocks;
    unsigned m_joints = 0;                                // that have bilateral rows
    std::vector<unsigned> m_unilateralRows, m_numberOf;      // unilateral rows, and back
    std::vector<unsigned> m_first, m_next;                // lists of part-sides: by body, by part-side
    std::vector<std::pair<unsigned, unsigned>> m_edges, m_orderedEdges;
    unsigned m_orderedJoints = 0;
    std::vector<dxInverseMass> m_inverseMasses;
    dxBodyVectors m_motions, m_unilateralForces, m_bilateralForces;
    std::vector<double> m_forces, m_low, m_high;          // by row
    std::vector<double> m_b, m_diagonal;                  // of the problem, by row
    std::vector<double> m_w;                              // by row
    dxBodyVectors m_accelerations;                        // by body
};
