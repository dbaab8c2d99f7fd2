#include "dynamics/world_step/exact/dxLcpMatrix.h"

#include <algorithm>
#include <utility>

#include "dynamics/world_step/exact/dxUpstreamLcp.h"
#include "dynamics/world_step/kernels/dxMirror.h"
#include "dynamics/world_step/kernels/dxTriangle.h"

namespace {

bool isBilateral(const dxDantzigProblem &problem, unsigned row) {
    if (problem.normalOf && problem.normalOf[row] >= 0) return false;  // its limits are set later
    const dReal *limits = problem.pairsLoHi + std::size_t(row) * PLH__MAX;
    return limits[PLH_LO] == -dInfinity && limits[PLH_HI] == dInfinity;
}

// Up to this number all rows are taken at once: there is little to save, and calls cost more.
constexpr unsigned kFewRows = 64;

unsigned countInPlace(const unsigned *order, unsigned n) {
    unsigned count = 0;
    while (count < n && order[count] == count) ++count;
    return count;
}

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

    // Columns that are all left of the row's own.
    void copyLeft(unsigned begin, unsigned end, dReal *row) const {
        for (unsigned j = begin; j < end; ++j) row[j] = left()[m_order[j]];
    }

    void copyAscending(unsigned begin, unsigned end, dReal *row) const {
        const auto isLeft = [this](unsigned column) { return column < m_own; };
        const auto middle = static_cast<unsigned>(std::partition_point(m_order + begin, m_order + end, isLeft) - m_order);
        copyLeft(begin, middle, row);
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

unsigned dxFindLcpOrder(const dxDantzigProblem &problem, unsigned *order) {
    for (unsigned i = 0; i < problem.n; ++i) order[i] = i;
    unsigned bilateral = problem.bilateral;
    for (unsigned i = bilateral; i < problem.n; ++i)
        if (isBilateral(problem, order[i])) std::swap(order[bilateral++], order[i]);
    if (!problem.normalOf) return bilateral;
    unsigned end = problem.n;
    for (unsigned i = problem.n; i-- > bilateral;)
        if (problem.normalOf[order[i]] >= 0) std::swap(order[i], order[--end]);
    return bilateral;
}

dxReorderedTriangle::dxReorderedTriangle(const dReal *lower, std::size_t skip, const unsigned *order, unsigned n)
    : m_lower(lower), m_skip(skip), m_order(order), m_inPlace(countInPlace(order, n)), m_ascending(countAscending(order, n)) {}

void dxReorderedTriangle::copyRow(unsigned index, dReal *to) const {
    const Row row(m_lower, m_skip, m_order, m_order[index]);
    const unsigned end = index + 1, first = std::min(m_inPlace, end), second = std::min(m_ascending, end);
    row.copyInPlace(first, to);
    if (end <= m_ascending) return row.copyLeft(first, end, to);
    row.copyAscending(first, second, to);
    row.copy(second, end, to);
}

bool dxLcpMatrix::takeBlock(unsigned index, bool isFinite) {
    const unsigned begin = m_end;
    m_end = m_n <= kFewRows ? m_n : std::min(m_n, (dxLcpBlock(index) + 1) * kLineLanes);
    for (unsigned i = begin; i < m_end; ++i) m_source.copyRow(i, row(i));
    return !isFinite || dxAreRowsFinite(m_rows, begin, m_end, static_cast<unsigned>(m_rowSkip));
}

void dxLcpMatrix::mirrorBlocks() {
    dxMirrorLower({m_rows, m_rowSkip, m_n, m_first, dxLcpBlock(m_mirrored) * kLineLanes, m_end});
    m_mirrored = m_end;
}
