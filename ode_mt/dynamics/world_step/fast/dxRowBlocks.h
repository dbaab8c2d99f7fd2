// An island's A = J inv(M) J' + cfm/h in blocks of joints, its bilateral rows apart from the unilateral ones:
//
//   | A_ee  A_ek  b_e |     e  bilateral rows, to be eliminated, joint by joint in the order of their elimination
//   |       A_kk  b_k |     k  unilateral rows, which are kept, in the order of the island's rows
//
// A_ee is sparse: a block for each two joints that share a body or come to (dxEliminationOrder, whose bodies are joints here). A_ek and
// b_e are one matrix, stored by rows of lines of kBodyLanes columns, of which only those in a mask are not 0; A_kk and b_k are another, the
// right-hand side being its last row. Both have a line more than they need: products are added by whole lines that begin anywhere.
//
// Invariants: a block's lanes and columns beyond its joints' rows are 0. All numbers are doubles, whatever dReal is.
//
// Bits do not depend on the instruction set: lanes are rows of a joint, or columns, and each element is one sum in one order, with products and
// sums apart (-ffp-contract=off).
// Source of the elimination: Golub and Van Loan, "Matrix Computations", 4.2; Cottle, Pang and Stone, "The Linear Complementarity Problem",
// 2.3 (a principal pivotal transform leaves the complementarity problem of the other rows).
//
// Threading: one island, one thread.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxEliminationOrder.h"

// The bilateral rows of one joint, or its unilateral ones.
struct dxRowPart {
    unsigned bodies[2];  // tags; kNoIndex: none
    unsigned firstRow;   // of the island
    unsigned rows;
    bool isUnilateral;
    unsigned place;  // of bilateral rows: in the elimination order; of unilateral ones: of the first one among those
};

struct dxRowBlocks {
    static constexpr unsigned kMaxLines = 64;  // bits of a mask

    std::vector<dxRowPart> parts;
    dxEliminationOrder order;

    // --- by part and side: column = element, lane = row -----------------------------------------------------
    dxBodyBlocks jacobian;
    dxBodyBlocks byMass;  // J inv(M)

    // Part-sides on the same body, 2 * part + side, the later part first; each with itself, too.
    std::vector<std::pair<unsigned, unsigned>> pairs;

    // --- A_ee: column = row of the earlier joint, lane = row of the later one --------------------------------
    std::vector<unsigned> sizes;  // rows, by place
    dxBodyBlocks diagonal, below;
    std::vector<double> inversePivots;  // kBodyAxes by place
    std::vector<unsigned> slotOf;       // of a joint in the block row under way

    // --- A_ek and A_kk -----------------------------------------------------------------------------------
    unsigned unilateralCount = 0;        // rows; column and row of b
    unsigned lines = 1;                  // of a row
    dxBodyVectors beside;                // by place kBodyAxes rows of `lines` lines
    std::vector<std::uint64_t> masks;    // by place: lines that are not 0
    dxBodyVectors unilateralRows;        // unilateralCount + 1 rows of `lines` lines, up to the diagonal's

    dxBodyVector *besideOf(unsigned place, unsigned row) { return beside.data() + (std::size_t(place) * kBodyAxes + row) * lines; }
    const dxBodyVector *besideOf(unsigned place, unsigned row) const {
        return beside.data() + (std::size_t(place) * kBodyAxes + row) * lines;
    }
    dxBodyVector *unilateralRow(unsigned row) { return unilateralRows.data() + std::size_t(row) * lines; }
    const dxBodyVector *unilateralRow(unsigned row) const { return unilateralRows.data() + std::size_t(row) * lines; }
};

// Elements of a row of lines.
inline double &dxElement(dxBodyVector *line, unsigned column) { return line[column / kBodyLanes].lane[column % kBodyLanes]; }
inline double dxElement(const dxBodyVector *line, unsigned column) { return line[column / kBodyLanes].lane[column % kBodyLanes]; }

// A pivot below this part of the diagonal's element is rounding: sums of a dozen rows leave less than 1e-14 of it.
constexpr double kMinPivot = 1e-11;

// Adds J inv(M) J' to the blocks, which hold cfm/h, and subtracts J u from the right-hand side, which is c/h. `inverseMasses` and `motions` (u)
// by tag. Writes blocks.byMass.
void dxMakeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions);

// Eliminates the bilateral rows: A_ee = L D L', left-looking, a block column for each joint, and with it
//
//   A_kk - A_ke inv(A_ee) A_ek  and  b_k - A_ke inv(A_ee) b_e
//
// the matrix and the right-hand side of the unilateral rows alone (Schur complement). The right-hand side is treated as one more row.
// Returns false where a pivot is none, or small beside the diagonal's element: the rows repeat one another.
bool dxEliminateRows(dxRowBlocks &blocks);

// Requires rows, eliminated. `unilateralForces`: lines as a row of A_ek, with -1 in the place of b. Writes the forces of the others, by place.
void dxSubstituteBack(const dxRowBlocks &blocks, const dxBodyVector *unilateralForces, dxBodyVectors &forces);
