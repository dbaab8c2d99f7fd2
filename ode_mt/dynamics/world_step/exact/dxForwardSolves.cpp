#include "dynamics/world_step/exact/dxForwardSolves.h"

#include <algorithm>
#include <cmath>

#include "core/dxNoIndex.h"
#include "dynamics/world_step/kernels/dxPair.h"
#include "dynamics/world_step/kernels/dxPanelSolve.h"
#include "dynamics/world_step/kernels/dxSolveL1Plain.h"

namespace {

// Up to this many blocks all have room.
constexpr unsigned kFewBlocks = 24;

unsigned blockCount(unsigned n, unsigned first) { return dxLcpBlock(n - 1) + 1 - dxLcpBlock(first); }

// More blocks have no fewer places: memory is estimated for all, and taken for those that are not without limits.
unsigned placeCount(unsigned blocks) { return blocks <= kFewBlocks ? blocks : std::max(kFewBlocks, blocks - blocks / 4); }

// Rows begin..end-1 of one of the lanes, both even.
void takeLane(const dReal *lane, unsigned begin, unsigned end, const dReal *d, const dxForwardSolves::Results &results) {
    const auto [toSolved, toScaled, toCopy] = results;
    for (unsigned row = begin; row < end; row += 2) {
        const dReal *const first = lane + std::size_t(row) * kLineLanes;
        const dxPair solved = {first[0], first[kLineLanes]}, scaled = solved * dxLoadPair(d + row);
        dxStorePair(solved, toSolved + row);
        dxStorePair(scaled, toScaled + row);
        dxStorePair(scaled, toCopy + row);
    }
}

}  // namespace

std::size_t dxForwardSolves::size(unsigned n, unsigned first) {
    return std::size_t(placeCount(blockCount(n, first))) * n * kLineLanes;
}

dxForwardSolves::dxForwardSolves(const dxLcpMatrix &A, const dxIndexSets &sets, const dReal *const *L,
                                 const dxSkyline &skyline, unsigned n, unsigned first,
                                 dReal *storage, unsigned *words)
    : m_A(A),
      m_sets(sets),
      m_L(L),
      m_skyline(skyline),
      m_n(n),
      m_firstBlock(dxLcpBlock(first)),
      m_endBlock(dxLcpBlock(n - 1) + 1),
      m_places(placeCount(blockCount(n, first))),
      m_solutions(storage),
      m_known(words),
      m_zeros(m_known + (m_endBlock - m_firstBlock)),
      m_place(m_zeros + (m_endBlock - m_firstBlock)),
      m_blockAt(m_place + (m_endBlock - m_firstBlock)),
      m_usedAt(m_blockAt + (m_endBlock - m_firstBlock)) {
    std::fill(m_known, m_place, 0u);
    std::fill(m_place, m_blockAt, kNoIndex);
}

void dxForwardSolves::solve(unsigned column, const dReal *d, const Results &results, const dxLcpWorkers &islandWorkers) {
    const unsigned rows = m_sets.countC(), grouped = rows / 4 * 4;
    const unsigned index = dxLcpBlock(column);
    findPlace(index);
    extend(index, grouped, islandWorkers);
    const dReal *lane = block(index) + column % kLineLanes;
    const unsigned zeros = std::min(m_zeros[index - m_firstBlock], grouped);
    for (unsigned row = 0; row < zeros; ++row) {
        results.solved[row] = 0;
        results.scaled[row] = results.copy[row] = 0 * d[row];
    }
    takeLane(lane, zeros, grouped, d, results);
    for (unsigned row = grouped; row < rows; ++row) {
        const unsigned other = m_sets.factorIndexes()[row];
        results.solved[row] = m_A.row(other)[column];
        dxSolve::solveStraightSingle<1>(m_L[row], results.solved, row);
        results.scaled[row] = results.copy[row] = results.solved[row] * d[row];
    }
}

void dxForwardSolves::findPlace(unsigned index) {
    unsigned &place = m_place[index - m_firstBlock];
    if (place == kNoIndex) {
        place = m_taken < m_places ? m_taken++ : leastRecentlyUsedPlace();
        m_blockAt[place] = index;
    }
    m_usedAt[place] = m_time++;
}

// Its block has nothing then.
unsigned dxForwardSolves::leastRecentlyUsedPlace() const {
    const auto place = static_cast<unsigned>(std::min_element(m_usedAt, m_usedAt + m_places) - m_usedAt);
    const unsigned block = m_blockAt[place] - m_firstBlock;
    m_place[block] = kNoIndex;
    m_known[block] = m_zeros[block] = 0;
    return place;
}

void dxForwardSolves::extend(unsigned index, unsigned rows, const dxLcpWorkers &islandWorkers) {
    unsigned &known = m_known[index - m_firstBlock];
    if (known >= rows) return;
    if (m_skyline.skipsZeros()) extendZeros(index, rows);
    if (known < rows)
        dxSolvePanel({m_L, m_A.rows() + index * kLineLanes, m_A.rowSkip(), m_sets.factorIndexes(), m_skyline,
                      m_zeros[index - m_firstBlock], known, rows, block(index)},
                     islandWorkers.runnerFor(std::size_t(rows - known) * rows));
    known = rows;
}

void dxForwardSolves::extendZeros(unsigned index, unsigned rows) {
    unsigned &known = m_known[index - m_firstBlock], &zeros = m_zeros[index - m_firstBlock];
    if (zeros < known) return;
    while (zeros < rows && isGroupZero(index, zeros)) zeros += 4;
    known = zeros;
}

// +0 in four rows of all columns: what is subtracted from it, 0 of either sign, leaves it so.
bool dxForwardSolves::isGroupZero(unsigned index, unsigned first) const {
    for (unsigned row = first; row < first + 4; ++row) {
        const dReal *lanes = m_A.row(m_sets.factorIndexes()[row]) + index * kLineLanes;
        for (unsigned lane = 0; lane < kLineLanes; ++lane)
            if (lanes[lane] != 0 || std::signbit(lanes[lane])) return false;
    }
    return true;
}

void dxForwardSolves::forgetFrom(unsigned row) {
    const unsigned left = row / 4 * 4;
    for (unsigned i = 0; i < m_endBlock - m_firstBlock; ++i) {
        m_known[i] = std::min(m_known[i], left);
        m_zeros[i] = std::min(m_zeros[i], left);
    }
}
