// Products of rows of a sparse matrix with a vector over C: upstream's dot products (ode/src/fastdot_impl.h) without
// most of the products that are zero.
//
// Few columns have an element in a row: those that share a body with it. Rows next to one another mostly have the same
// ones, as those of contacts of the same two bodies. So the elements of four rows (eight in single precision) in a
// column of C are stored together, half a cache line, if one of them is not zero; these pieces of a block have the
// order of C, and follow each change of it.
#pragma once

#include <ode/common.h>

#include <cstddef>
#include <cstdint>

#include "dynamics/world_step/exact/dxIndexSets.h"
#include "dynamics/world_step/exact/dxLcpMatrix.h"
#include "dynamics/world_step/exact/dxLcpWorkers.h"
#include "dynamics/world_step/kernels/dxSymmetricProducts.h"

class dxWorldProcessMemArena;

class dxSparseRows {
public:
    // Rows first..n-1 of n. Costs nothing until it is built.
    dxSparseRows(const dxLcpMatrix &A, const dxIndexSets &sets, unsigned n, unsigned first);

    // Of the memory that build takes, in bytes: less than a quarter of the matrix's.
    static std::size_t memory(unsigned n);

    // Gathers the elements of the rows in the columns of C, unless too many are not zero.
    void build(dxWorldProcessMemArena *arena);

    bool isTried() const { return m_begins != nullptr; }
    bool isBuilt() const { return m_pieces != nullptr; }

    // result(row) = the sum over C of A(row, column) * factors[position], for rows before `endRow` in wanted half blocks of
    // lanes.
    void multiply(const dReal *factors, unsigned endRow, const unsigned *wanted, dReal *result,
                  const dxLcpWorkers &islandWorkers) const;

    // Requires a call when a column was appended to C.
    void append(unsigned column);

    // Requires a call before C loses the column at a position, which the last one then takes.
    void remove(unsigned position);

private:
    const std::uint64_t *pattern(unsigned column) const { return m_pattern + column * m_patternWords; }
    void findPattern();
    void insertColumn(unsigned column, unsigned position);
    void eraseColumn(unsigned column, unsigned position);
    void insert(unsigned block, unsigned position, const dReal *piece);
    void erase(unsigned block, unsigned position);
    unsigned findPiece(unsigned block, unsigned position) const;
    dReal *piece(unsigned block, unsigned k) const { return m_pieces + (m_begins[block] + std::size_t(k)) * kHalfLine; }

    const dxLcpMatrix &m_A;
    const dxIndexSets &m_sets;
    const unsigned m_n, m_firstBlock, m_blocks;
    const std::size_t m_patternWords;

    std::uint64_t *m_pattern = nullptr;  // by column: a bit for each block that has elements there

    // By block; its pieces have room for all columns with elements.
    unsigned *m_begins = nullptr;  // one more than blocks
    unsigned *m_counts = nullptr;

    unsigned *m_positions = nullptr;  // by piece
    dReal *m_pieces = nullptr;         // null until built
};
