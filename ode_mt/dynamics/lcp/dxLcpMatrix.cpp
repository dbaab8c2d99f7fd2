#include "dynamics/lcp/dxLcpMatrix.h"

#include <algorithm>

#include "dynamics/solve/dxMirror.h"

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
    dxMirrorLower({m_rows, m_rowSkip, n, first});
}
