#include "dynamics/lcp/dxLcpMatrix.h"

#include <algorithm>

namespace {

// Rows of the problem that are in their own places, from the first on: they are copied in one go.
unsigned countInPlace(const unsigned *order, unsigned n) {
    unsigned count = 0;
    while (count < n && order[count] == count) ++count;
    return count;
}

// Columns begin..index of row `index`.
void copyRow(const dReal *lower, std::size_t skip, const unsigned *order, unsigned index, unsigned begin, dReal *row) {
    const unsigned own = order[index];
    for (unsigned j = begin; j <= index; ++j) {
        const unsigned other = order[j];
        row[j] = lower[std::max(own, other) * skip + std::min(own, other)];
    }
}

}  // namespace

void dxCopyLcpRows(const dReal *lower, std::size_t skip, const unsigned *order, unsigned begin, unsigned end,
                   dReal *copy, std::size_t copySkip) {
    const unsigned inPlace = countInPlace(order, end);
    for (unsigned i = begin; i < end; ++i) {
        const unsigned copied = std::min(inPlace, i + 1);
        dReal *const row = copy + i * copySkip;
        std::copy_n(lower + order[i] * skip, copied, row);
        copyRow(lower, skip, order, i, copied, row);
    }
}

dxLcpMatrix::dxLcpMatrix(const dReal *lower, std::size_t skip, const unsigned *order, unsigned n,
                         unsigned first, dReal *storage)
    : m_rows(storage), m_rowSkip(dxLcpRoundUp(n)) {
    dxCopyLcpRows(lower, skip, order, first, n, m_rows, m_rowSkip);
    for (unsigned begin = dxLcpBlock(first) * kLineLanes; begin < n; begin += kLineLanes)
        mirror(begin, first, n);
}

// Columns begin.. of a block of lanes, for the rows before them. Lanes of columns that are never asked for
// are 0.
void dxLcpMatrix::mirror(unsigned begin, unsigned first, unsigned n) {
    const unsigned end = begin + kLineLanes;
    unsigned whole = 0;  // rows that have been done
    if (begin >= first && end <= n) {
        const dReal *block = row(begin);
        for (; whole < begin; ++whole)
            for (unsigned i = 0; i < kLineLanes; ++i) row(whole)[begin + i] = block[i * m_rowSkip + whole];
    }
    for (unsigned j = whole; j < std::min(end, n); ++j)
        for (unsigned i = std::max({begin, first, j + 1}); i < std::min(end, n); ++i) row(j)[i] = row(i)[j];
    for (unsigned j = 0; j < first; ++j) std::fill(row(j) + begin, row(j) + std::max(begin, first), dReal(0));
    for (unsigned j = 0; end > n && j < n; ++j) std::fill(row(j) + n, row(j) + end, dReal(0));
}
