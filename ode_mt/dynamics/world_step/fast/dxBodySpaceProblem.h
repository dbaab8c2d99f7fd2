// An island's linear complementarity problem in body space: the same problem as dxWorldStepProblem's, without the matrix
// A = J inv(M) J' + cfm/h, whose memory and time grow with the square and the cube of the number of rows.
//
// Its solution x makes these the minimum over changes u of all bodies' velocities per step size (accelerations):
//
//   F(u) = 1/2 u' M u + sum of p(i)(b(i) - J(i) u),  x(i) = p(i)' = clamp((b(i) - J(i) u) / c(i), lo(i), hi(i)),  M u = J' x
//
// which is strictly convex and piecewise quadratic: p(i) is quadratic between the limits and linear beyond them. With
// w(i) = J(i) u + c(i) x(i) - b(i) the clamping is w(i) >= 0 at lo(i), w(i) <= 0 at hi(i) and w(i) = 0 between them, as upstream has it.
//
// Invariants: bodies that no force moves (kinematic ones, the world) are none. Bodies are numbered by their place in the elimination
// order. Rows of the same two bodies stand side by side: a manifold. All numbers are doubles, whatever dReal is.
// Units: those of the user's world.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

struct dxWorldStepProblem;

// Rows that act on the same one or two bodies.
struct dxManifold {
    static constexpr unsigned kNoBody = ~0u;

    unsigned firstRow, endRow;
    unsigned body[2];  // the first one is eliminated before the second; kNoBody: none
    unsigned block;    // of the factorisation, for two bodies: row body[1], column body[0]
};

struct dxBodySpaceProblem {
    static constexpr int kNoNormal = -1;

    unsigned bodyCount = 0, rowCount = 0;
    dxBodyBlocks mass;         // M, by body
    dxBodyBlocks inverseMass;  // inv(M)
    std::vector<dxManifold> manifolds;

    // --- rows ---------------------------------------------------------------------------------------------
    dxBodyVectors jacobian;         // two for each row, for the manifold's bodies; 0 where there is none
    std::vector<double> b, c;       // the right-hand side, cfm/h
    std::vector<double> lo, hi;     // of friction rows relative to the normal's force
    std::vector<int> normalOf;      // for friction rows the row of the normal, else kNoNormal
    std::vector<double> diagonal;   // J inv(M) J' of each row

    bool isFriction(unsigned row) const { return normalOf[row] != kNoNormal; }

    // c, or the least of it, as part of the diagonal, with which rows are solved; corrections make up for the difference.
    double softnessOf(unsigned row) const { return std::max(c[row], kMinSoftness * diagonal[row]); }
    static constexpr double kMinSoftness = 1e-12;

    // Whether c counts beside the diagonal.
    static bool isSoft(double c, double diagonal) { return c > kMinSoftness * diagonal; }
};

// Makes that problem of the rows that joints have written, and the elimination order of its bodies.
class dxBodySpaceRows {
public:
    // Requires rows, c/h and cfm/h in the places of b and x (dxReadRows). Returns false if the problem has numbers that are not
    // finite, or a body that moves and has no inertia: such islands are for the exact solver.
    bool gather(const dxWorldStepProblem &rows, double stepSize);

    const dxBodySpaceProblem &problem() const { return m_problem; }
    dxBodySpaceProblem &problem() { return m_problem; }
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

    dxBodySpaceProblem m_problem;
    dxEliminationOrder m_order;
    std::vector<unsigned> m_numberOf;                    // by tag: among bodies that move
    std::vector<unsigned> m_tagOf;
    std::vector<std::pair<unsigned, unsigned>> m_edges;
    std::vector<Pair> m_pairs;
    std::vector<unsigned> m_sourceOf, m_rowOf;           // rows here and there
    dxBodyVectors m_motions;
};
