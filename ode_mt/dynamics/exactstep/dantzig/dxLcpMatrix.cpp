#include "dynamics/exactstep/dantzig/dxLcpMatrix.h"

#include <algorithm>

#include "dynamics/exactstep/kernels/dxMirror.h"

namespace {

// Positions from 0 on that hold rows of the problem in their own places: they are copied in one go.
unsigned countInPlace(const unsigned *order, unsigned n) {
    unsigned count = 0;
    while (count < n && order[count] == count) ++count;
    return count;
}

// Positions from 0 on whose rows of the problem ascend, as those without limits do unless they were moved there.
unsigned countAscending(const unsigned *order, unsigned n) {
    unsigned count = std::min(n, 1u);
    while (count < n && order[count - 1] < order[count]) ++count;
    return count;
}

// A row of the problem in another order of columns. Only the lower triangle is there: what is right of the diagonal is
// below it.
class Row {
public:
    Row(const dReal *lower, std::size_t skip, const unsigned *order, unsigned own)
        : m_lower(lower), m_skip(skip), m_order(order), m_own(own) {}

    void copyInPlace(unsigned end, dReal *row) const { std::copy_n(left(), end, row); }

    void copyAscending(unsigned begin, unsigned end, dReal *row) const {
        const auto isLeft = [this](unsigned column) { return column < m_own; };
        const auto middle = static_cast<unsigned>(std::partition_point(m_order + begin, m_order + end, isLeft) - m_order);
        const dReal *const left = this->left();
        for (unsigned j = begin; j < middle; ++j) row[j] = left[m_order[j]];
        for (unsigned j = middle; j < end; ++j) row[j] = below(m_order[j]);
    }

    void copy(unsigned begin, unsigned end, dReal *row) const {
        for (unsigned j = begin; j < end; ++j) {
            const unsigned other = m_order[j];
            row[j] = m_lower[std::max(m_own, other) * m_skip + std::min(m_own, other)];
        }
    }

private:
    const dReal *left() const { return m_lower + m_own * m_skip; }
    const dReal &below(unsigned column) const { return m_lower[column * m_skip + m_own]; }

    const dReal *m_lower;
    std::size_t m_skip;
    const unsigned *m_order;
    unsigned m_own;
};

}  // namespace

void dxCopyLcpRows(const dReal *lower, std::size_t skip, const unsigned *order, unsigned begin, unsigned end,
                   dReal *copy, std::size_t copySkip) {
    const unsigned inPlace = countInPlace(order, end), ascending = countAscending(order, end);
    for (unsigned i = begin; i < end; ++i) {
        const Row row(lower, skip, order, order[i]);
        dReal *const to = copy + i * copySkip;
        const unsigned first = std::min(inPlace, i + 1), second = std::min(ascending, i + 1);
        row.copyInPlace(first, to);
        row.copyAscending(first, second, to);
        row.copy(second, i + 1, to);
    }
}

dxLcpMatrix::dxLcpMatrix(const dReal *lower, std::size_t skip, const unsigned *order, unsigned n,
                         unsigned first, dReal *storage)
    : m_rows(storage), m_rowSkip(dxLcpRoundUp(n)) {
    dxCopyLcpRows(lower, skip, order, first, n, m_rows, m_rowSkip);
    dxMirrorLower({m_rows, m_rowSkip, n, first});
}
