// The matrix of an LCP, in the order of its solver: rows whose limits depend on others are last, rows without limits
// first. Both triangles are stored for the columns that are not processed yet, so that a column of the triangle is a
// row of lanes. Lanes come in blocks of kLineLanes consecutive columns.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "core/dxCacheLine.h"

inline unsigned dxLcpBlock(unsigned index) { return index / kLineLanes; }
inline unsigned dxLcpHalfBlock(unsigned index) { return index / kHalfLine; }
inline unsigned dxLcpRoundUp(unsigned n) { return (n + kLineLanes - 1) / kLineLanes * kLineLanes; }

// Copies rows begin..end-1, up to the diagonal, in the order `order`, of a symmetric matrix of which the lower
// triangle is stored in another: its rows start `skip` elements apart, those of the copy `copySkip`, row 0 at `copy`.
void dxCopyLcpRows(const dReal *lower, std::size_t skip, const unsigned *order, unsigned begin, unsigned end,
                   dReal *copy, std::size_t copySkip);

class dxLcpMatrix {
public:
    // Elements of storage: whole blocks of rows, too.
    static std::size_t size(unsigned n) { return std::size_t(dxLcpRoundUp(n)) * dxLcpRoundUp(n); }

    // `lower`: the lower triangle of the problem's matrix, whose rows start `skip` elements apart; `order`: the
    // problem's row for each of ours; `first`: the first column that is to be kept in rows before it, too. `storage` is
    // aligned to cache lines.
    dxLcpMatrix(const dReal *lower, std::size_t skip, const unsigned *order, unsigned n, unsigned first,
                dReal *storage);

    std::size_t rowSkip() const { return m_rowSkip; }
    const dReal *rows() const { return m_rows; }

    // Row `index`: the columns from the block of `first` on, and those before if index >= first; zeros follow
    // the last.
    dReal *row(unsigned index) const { return m_rows + m_rowSkip * index; }
    dReal diagonal(unsigned index) const { return row(index)[index]; }

private:
    dReal *const m_rows;
    const std::size_t m_rowSkip;
};
