// Products of rows of a sparse matrix with a vector over C: upstream's dot products (ode/src/fastdot_impl.h) without
// the products that are zero.
//
// Few columns have an element in a row: those that share a body with it. Upstream adds four products to one another,
// for positions 4k to 4k + 3 in C, then to the sum, and those left over one by one. So a row's elements are kept by
// groups of four positions, in order, and follow each change of C.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "dynamics/lcp/dxIndexSets.h"
#include "dynamics/lcp/dxLcpMatrix.h"

class dxWorldProcessMemArena;

class dxSparseRows {
public:
    // Rows first..n-1 of n. Until it is built it takes no time.
    dxSparseRows(const dxLcpMatrix &A, const dxIndexSets &sets, unsigned n, unsigned first)
        : m_A(A), m_sets(sets), m_n(n), m_first(first) {}

    // Of the memory that build takes, in bytes.
    static std::size_t memory(unsigned n);

    // Gathers the elements of the rows in the columns of C, unless too many are not zero.
    void build(dxWorldProcessMemArena *arena);

    bool isTried() const { return m_begins != nullptr; }
    bool isBuilt() const { return m_groupCounts != nullptr; }

    // The sum over C of A(row, column) * factors[position].
    dReal multiply(unsigned row, const dReal *factors) const;

    // C has got a column at its end.
    void append(unsigned column);

    // C is about to lose the column at a position, which the last one then takes.
    void remove(unsigned position);

private:
    struct Group {
        dReal elements[4];
    };

    void count();
    void fillPattern();
    void insertColumn(unsigned column, unsigned position);
    void eraseColumn(unsigned column, unsigned position);
    void insert(unsigned row, unsigned position, dReal element);
    void erase(unsigned row, unsigned position);
    unsigned findGroup(unsigned row, unsigned group) const;

    const dxLcpMatrix &m_A;
    const dxIndexSets &m_sets;
    const unsigned m_n, m_first;

    // By row:
    unsigned *m_begins = nullptr;       // of its pattern, and of its groups; n + 1
    unsigned *m_patternEnds = nullptr;
    unsigned *m_groupCounts = nullptr;  // null until built

    unsigned *m_pattern = nullptr;       // rows with an element in a column, by column
    unsigned *m_groupNumbers = nullptr;  // by row, rising
    Group *m_groups = nullptr;           // the same
};
