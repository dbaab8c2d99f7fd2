// The numeric factorisation H = L L' of a symmetric, positive definite matrix of 6 x 6 blocks, a block for each two bodies of an
// island that share joints or come to (dxEliminationOrder), and solves with it. Left-looking Cholesky: a column gets the
// products of all columns before it that have its row, and is then divided by its own diagonal block.
// Source: Golub and Van Loan, "Matrix Computations", 4.2; Davis, "Direct Methods for Sparse Linear Systems", chapter 4.
//
// Diagonal blocks are inverted, so that a solve has products of vectors, not a chain of 36 dependent operations for each body.
//
// The bits do not depend on the instruction set: a lane is a row of a block, and each element is one sum in one order, with products
// and sums apart (-ffp-contract=off).
//
// Tried and dropped: right-looking, which writes a column of the heap of 400 as often as it has neighbours; rows of blocks as lanes of
// columns next to one another (supernodes), since columns of a wall share few.
#pragma once

#include "dynamics/direct/dxBodyBlocks.h"
#include "dynamics/direct/dxEliminationOrder.h"

// inv(L) of a diagonal block. Upper and lower triangles are 0.
struct dxPivotInverse {
    dxBodyBlock byColumns, byRows;
};

class dxBlockFactor {
public:
    // Keeps the order by reference. Blocks are as large as it says.
    void shape(const dxEliminationOrder &order);

    // H, to be written before factorise: of the diagonal blocks the lower triangle is read.
    dxBodyBlocks &diagonal() { return m_diagonal; }
    dxBodyBlocks &below() { return m_below; }

    // Writes L over H, but for the diagonal blocks. Returns false where H is not positive definite in this arithmetic; L is of no use then.
    bool factorise();

    // Writes inv(H) y over y.
    void solve(dxBodyVectors &y) const;

private:
    const dxEliminationOrder *m_order = nullptr;
    dxBodyBlocks m_diagonal, m_below;
    std::vector<dxPivotInverse> m_inverses;
    std::vector<unsigned> m_slotOf;  // of a row in the column under way
};
