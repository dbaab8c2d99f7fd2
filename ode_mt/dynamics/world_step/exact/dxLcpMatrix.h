// An LCP, the order in which its solver takes the rows, and its matrix in that order: rows whose limits depend on others are last, bilateral rows
// first. Both triangles are stored for the columns that are not processed yet, so that a column of the triangle is a
// row of lanes. Lanes come in blocks of kLineLanes consecutive columns.
//
// Rows are taken from the problem as the solver comes to them, and mirrored when a column is needed: upstream's solver may give up
// after a few rows of many, or have no row that is free, and what it does not look at costs it nothing.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "core/dxCacheLine.h"

// An LCP as upstream's step hands it over: what dxSolveDantzig (dxDantzig.h) is given.
struct dxDantzigProblem {
    unsigned n;
    const dReal *A;  // lower triangle
    dReal *pairsBX;
    unsigned bilateral;
    const dReal *pairsLoHi;
    const int *normalOf;
};

// Writes the order in which Dantzig's algorithm takes the rows of a problem, the problem's row for each of the solver's: bilateral rows first,
// rows whose limits depend on others last, the rest as upstream's swaps leave them. Returns how many bilateral rows there are.
unsigned dxFindLcpOrder(const dxDantzigProblem &problem, unsigned *order);

inline unsigned dxLcpBlock(unsigned index) { return index / kLineLanes; }
inline unsigned dxLcpHalfBlock(unsigned index) { return index / kHalfLine; }
inline unsigned dxLcpRoundUp(unsigned n) { return (n + kLineLanes - 1) / kLineLanes * kLineLanes; }

// The problem's matrix in another order of rows and columns.
class dxReorderedTriangle {
public:
    // `lower`: its lower triangle, whose rows start `skip` elements apart; `order`: the problem's row for each of ours.
    dxReorderedTriangle(const dReal *lower, std::size_t skip, const unsigned *order, unsigned n);

    // Copies row `index` up to the diagonal.
    void copyRow(unsigned index, dReal *to) const;

private:
    const dReal *const m_lower;
    const std::size_t m_skip;
    const unsigned *const m_order;
    const unsigned m_inPlace;    // positions from 0 on that hold the problem's rows in their own places: copied in one go
    const unsigned m_ascending;  // positions from 0 on whose rows of the problem ascend, as those without limits mostly do
};

class dxLcpMatrix {
public:
    // Elements of storage: whole blocks of rows, too.
    static std::size_t size(unsigned n) { return std::size_t(dxLcpRoundUp(n)) * dxLcpRoundUp(n); }

    // `first`: the first row that is taken, and the first column that is kept in rows before it, too. `storage` is aligned to
    // cache lines.
    dxLcpMatrix(const dxReorderedTriangle &source, unsigned n, unsigned first, dReal *storage)
        : m_source(source), m_rows(storage), m_rowSkip(dxLcpRoundUp(n)), m_n(n), m_first(first), m_end(first), m_mirrored(first) {}

    // Takes rows up to the end of the block of `index`. Returns false if `isFinite` is asked for and they are not.
    bool take(unsigned index, bool isFinite) { return index < m_end || takeBlock(index, isFinite); }

    // Rows before it have been taken.
    unsigned end() const { return m_end; }

    // Makes the columns of all rows that have been taken. Required before any row is read to the right of its diagonal.
    void mirror() {
        if (m_mirrored < m_end) mirrorBlocks();
    }

    std::size_t rowSkip() const { return m_rowSkip; }
    const dReal *rows() const { return m_rows; }

    // Row `index`: the columns from the block of `first` on, and those before if index >= first; zeros follow
    // the last of the problem.
    dReal *row(unsigned index) const { return m_rows + m_rowSkip * index; }
    dReal diagonal(unsigned index) const { return row(index)[index]; }

private:
    bool takeBlock(unsigned index, bool isFinite);
    void mirrorBlocks();

    const dxReorderedTriangle &m_source;
    dReal *const m_rows;
    const std::size_t m_rowSkip;
    const unsigned m_n, m_first;
    unsigned m_end, m_mirrored;  // rows that have been taken, that have been mirrored: whole blocks, or all
};
