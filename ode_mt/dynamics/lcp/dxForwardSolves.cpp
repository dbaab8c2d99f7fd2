#include "dynamics/lcp/dxForwardSolves.h"

#include <algorithm>

#include "dynamics/solve/dxPanelSolve.h"
#include "dynamics/solve/dxSolveL1Plain.h"

std::size_t dxForwardSolves::size(unsigned n, unsigned first) {
    return std::size_t(dxLcpBlock(n - 1) + 1 - dxLcpBlock(first)) * n * kLineLanes;
}

dxForwardSolves::dxForwardSolves(const dxLcpMatrix &A, const dxIndexSets &sets, const dReal *L,
                                 std::size_t rowSkip, unsigned n, unsigned first, dReal *storage,
                                 unsigned *words)
    : m_A(A),
      m_sets(sets),
      m_L(L),
      m_rowSkip(rowSkip),
      m_n(n),
      m_firstBlock(dxLcpBlock(first)),
      m_endBlock(dxLcpBlock(n - 1) + 1),
      m_solutions(storage),
      m_known(words) {
    std::fill(m_known, m_known + (m_endBlock - m_firstBlock), 0u);
}

void dxForwardSolves::solve(unsigned column, dReal *result) {
    const unsigned rows = m_sets.countC(), grouped = rows / 4 * 4;
    const unsigned index = dxLcpBlock(column);
    extend(index, grouped);
    const dReal *lane = block(index) + column % kLineLanes;
    for (unsigned row = 0; row < grouped; ++row) result[row] = lane[std::size_t(row) * kLineLanes];
    for (unsigned row = grouped; row < rows; ++row) {
        const unsigned other = m_sets.factorIndexes()[row];
        result[row] = m_A.row(other)[column];
        dxSolve::solveStraightSingle<1>(m_L + row * m_rowSkip, result, row);
    }
}

void dxForwardSolves::extend(unsigned index, unsigned rows) {
    unsigned &known = m_known[index - m_firstBlock];
    if (known >= rows) return;
    dxSolvePanel({m_L, m_rowSkip, m_A.rows() + index * kLineLanes, m_A.rowSkip(), m_sets.factorIndexes(),
                  known, rows, block(index)});
    known = rows;
}

void dxForwardSolves::forgetFrom(unsigned row) {
    const unsigned left = row / 4 * 4;
    for (unsigned i = 0; i < m_endBlock - m_firstBlock; ++i) m_known[i] = std::min(m_known[i], left);
}
