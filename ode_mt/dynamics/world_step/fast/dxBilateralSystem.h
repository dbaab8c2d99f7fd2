// An island all of whose rows are bilateral, as one linear system A x = b with A = J inv(M) J' + cfm/h in blocks of joints, and the kernels
// that make, factorise and solve it (L D L').
//
// It is dxRowBlocks.h without unilateral rows, and packed: columns of ball joints, by far the most, have four lanes instead of eight and no
// linear part, b is a vector, and what has not changed of the island's structure is neither found nor cleared again. Where the factor has many
// blocks (nets), the matrix is factorised by fronts instead of columns of blocks (dxFrontFactor.h).
//
// Joints are numbered by their places in the elimination order; so are the rows of all arrays. Invariants: lanes beyond a joint's rows are
// 0 once the structure is there, and stay 0. All numbers are doubles, whatever dReal is.
//
// Bits do not depend on the instruction set nor on threads: lanes are rows, each element is one sum in one order, products and sums are apart.
//
// Threading: one island, one thread; where it is in fronts, the workers of a large island.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"
#include "dynamics/world_step/fast/dxFrontFactor.h"

struct dxBilateralJoint {
    unsigned bodies[2];  // tags; the second one may be kNoIndex: none
    unsigned rows;
    bool isBall;
};

struct dxBilateralSizes {
    double residual = 0;  // the largest |w|
    double sum = 0;       // the largest |A(i,i) x(i)|
};

struct dxBilateralSystem {
    // Vectors of a joint, a lane for each row.
    enum Vector : unsigned {
        kGiven,         // c/h
        kSoftness,      // cfm/h
        kRightSide,     // b, then inv(L) b
        kInversePivot,  // inv(D)
        kDiagonal,      // of A
        kForce,         // x
        kVectors
    };

    // Two joints' sides on one body, of which the first one's column has the block.
    struct Pair {
        unsigned side;   // of the block's column
        unsigned other;  // 2 * place + side of the block's row
    };

    // --- structure -------------------------------------------------------------------------------------------
    bool isBalls = false;  // ball joints alone: their linear rows are the unit matrix for the first body, less it for the second
    unsigned lanes() const { return isBalls ? kBallLanes : kBodyLanes; }  // of a column
    static constexpr unsigned kBallLanes = 4;

    std::vector<dxBilateralJoint> joints;
    dxEliminationOrder order;
    std::vector<unsigned> firstPair;  // by block, and the end of the last one's: none for fill
    std::vector<Pair> pairs;
    std::vector<unsigned> slotOf;     // of a joint in the block row under way

    // Whether the system is factorised by fronts: few joints, chains and trees are by columns of blocks.
    bool isInFronts = false;
    dxFrontPlan frontPlan;

    // Requires all of the structure before. Decides how it is factorised, and clears all arrays.
    void takeMemory();

    // --- numbers ---------------------------------------------------------------------------------------------
    dxBodyVectors jacobian;           // by joint and side: kBodyAxes columns; of ball joints alone only the angular ones
    dxBodyVectors diagonal, below;    // A, then its factor, if not in fronts: by joint and by block a column for each row of the block's column
    dxBodyVectors vectors;            // by joint
    double largestB = 0;              // of |b|
    dxFrontFactor fronts;
    dxPhaseRunner phases;
    std::vector<double> largestBOf;   // by share

    unsigned columns() const { return isBalls ? kBallLanes : kBodyAxes; }  // of a block
    double *jacobianOf(unsigned joint, unsigned side) { return numbers(jacobian, (2 * std::size_t(joint) + side) * kBodyAxes); }
    double *vectorOf(unsigned joint, Vector which) { return numbers(vectors, std::size_t(joint) * kVectors + which); }

    // Requires the structure, the Jacobian, c/h and cfm/h. `motions`: v/h + inv(M) f by body. Writes x and largestB. Returns false where a
    // pivot is rounding beside its diagonal, or is no finite number.
    bool solve(dxTaskRunner &runner, const dxInverseMass *inverseMasses, const dxBodyVector *motions);

    // Requires x, and of each body inv(M) J' x + v/h + inv(M) f. Sizes are infinite where a number is not finite.
    dxBilateralSizes findResidual(const dxBodyVector *accelerations);

private:
    double *numbers(dxBodyVectors &array, std::size_t column) { return reinterpret_cast<double *>(array.data()) + column * lanes(); }
};

