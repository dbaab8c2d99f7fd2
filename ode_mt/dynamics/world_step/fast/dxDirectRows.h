// The rows of an island in body space: dxDirectProblem and its elimination order, from rows that joints have written.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxDirectProblem.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

struct dxWorldStepProblem;

class dxDirectRows {
public:
    // Requires rows, c/h and cfm/h in the places of b and x (dxReadRows). Returns false if the problem has numbers that are not
    // finite, or a body that moves and has no inertia: such islands are for the exact solver.
    bool gather(const dxWorldStepProblem &rows, double stepSize);

    const dxDirectProblem &problem() const { return m_problem; }
    dxDirectProblem &problem() { return m_problem; }
    const dxEliminationOrder &order() const { return m_order; }
    const dxBodyVectors &motions() const { return m_motions; }  // v/h + inv(M) f, by tag

    // x, in the order of the rows here, in the places where dxApplyResults reads it.
    void writeForces(const std::vector<double> &x, const dxWorldStepProblem &rows) const;
    void readForces(const dxWorldStepProblem &rows, std::vector<double> &x) const;

private:
    struct Pair {
        unsigned first, second;  // places in the elimination order; dxManifold::kNoBody: none
        unsigned joint;
        bool isSwapped;  // the joint's first body is the pair's second one
    };

    bool numberBodies(const dxWorldStepProblem &rows);
    void orderBodies(const dxWorldStepProblem &rows);
    bool fillMasses(const dxWorldStepProblem &rows);
    void pairJoints(const dxWorldStepProblem &rows);
    bool fillRows(const dxWorldStepProblem &rows);
    bool fillRow(const dxWorldStepProblem &rows, const Pair &pair, unsigned source, unsigned row);
    void findDiagonal();
    unsigned placeOf(const dxWorldStepProblem &rows, unsigned joint, unsigned side) const;

    dxDirectProblem m_problem;
    dxEliminationOrder m_order;
    std::vector<unsigned> m_numberOf;                    // by tag: among bodies that move
    std::vector<unsigned> m_tagOf;
    std::vector<std::pair<unsigned, unsigned>> m_edges;
    std::vector<Pair> m_pairs;
    std::vector<unsigned> m_sourceOf, m_rowOf;           // rows here and there
    dxBodyVectors m_motions;
};
