#include "dynamics/world_step/exact/dxSparseRows.h"

#include <algorithm>

#include "dynamics/world_step/exact/dxDantzigArrays.h"

namespace {

// At most one in kSparsity pieces of all rows is kept.
constexpr std::size_t kSparsity = 5;

constexpr unsigned kWordBits = 64;

// That one worker takes at once.
constexpr std::size_t kSharedBlocks = 16;

unsigned blockCount(unsigned n) { return dxLcpHalfBlock(n - 1) + 1; }

std::size_t maxPieces(unsigned n) { return std::size_t(n) * blockCount(n) / kSparsity; }

// Calls visit(block) for each bit.
template <class Visit>
void forBits(const std::uint64_t *words, std::size_t count, Visit visit) {
    for (std::size_t word = 0; word < count; ++word)
        for (std::uint64_t left = words[word]; left != 0; left &= left - 1)
            visit(static_cast<unsigned>(word * kWordBits) + static_cast<unsigned>(__builtin_ctzll(left)));
}

std::size_t patternWords(unsigned blocks) { return (blocks + kWordBits - 1) / kWordBits; }

}  // namespace

dxSparseRows::dxSparseRows(const dxLcpMatrix &A, const dxIndexSets &sets, unsigned n, unsigned first)
    : m_A(A),
      m_sets(sets),
      m_n(n),
      m_firstBlock(dxLcpHalfBlock(first)),
      m_blocks(blockCount(n)),
      m_patternWords(patternWords(m_blocks - m_firstBlock)) {}

std::size_t dxSparseRows::memory(unsigned n) {
    const unsigned blocks = blockCount(n);
    return dxArrayBytes<std::uint64_t>(n * patternWords(blocks)) + dxArrayBytes<unsigned>(blocks + std::size_t(1)) +
           dxArrayBytes<unsigned>(blocks) + dxArrayBytes<unsigned>(maxPieces(n)) +
           dxArrayBytes<dReal>(maxPieces(n) * kHalfLine);
}

void dxSparseRows::build(dxWorldProcessMemArena *arena) {
    m_pattern = dxTakeArray<std::uint64_t>(arena, m_n * m_patternWords);
    m_begins = dxTakeArray<unsigned>(arena, m_blocks + std::size_t(1));
    findPattern();
    if (m_begins[m_blocks] > maxPieces(m_n)) return;
    m_counts = dxTakeArray<unsigned>(arena, m_blocks);
    m_positions = dxTakeArray<unsigned>(arena, m_begins[m_blocks]);
    m_pieces = dxTakeArray<dReal>(arena, std::size_t(m_begins[m_blocks]) * kHalfLine);
    std::fill_n(m_counts, m_blocks, 0u);
    for (unsigned position = 0; position < m_sets.countC(); ++position)
        insertColumn(m_sets.indexAt(position), position);
}

// The matrix is symmetric: a column is its row.
void dxSparseRows::findPattern() {
    std::fill_n(m_begins, m_blocks + std::size_t(1), 0u);
    for (unsigned column = 0; column < m_n; ++column) {
        std::uint64_t *const bits = m_pattern + column * m_patternWords;
        dxMarkPieces(m_A.row(column) + std::size_t(m_firstBlock) * kHalfLine, m_blocks - m_firstBlock, bits);
        forBits(bits, m_patternWords, [&](unsigned block) { ++m_begins[m_firstBlock + block + 1]; });
    }
    for (unsigned block = 0; block < m_blocks; ++block) m_begins[block + 1] += m_begins[block];
}

void dxSparseRows::multiply(const dReal *factors, unsigned endRow, const unsigned *wanted, dReal *result,
                            const dxLcpWorkers &islandWorkers) const {
    const unsigned endBlock = blockCount(endRow);
    const auto multiplyBlocks = [&](unsigned begin, unsigned end) {
        dxComputeSparseProducts(
            {m_begins, m_counts, m_pieces, m_positions, factors, m_sets.countC(), begin, end, wanted, result});
    };
    dxTaskRunner *const runner = islandWorkers.runnerFor(std::size_t(m_begins[endBlock]) * kHalfLine / 2);  // of all half are in C
    if (runner == nullptr) return multiplyBlocks(m_firstBlock, endBlock);
    runner->forChunks(dxParallelStage::SparseProducts, endBlock - m_firstBlock, kSharedBlocks,
        [&](std::size_t begin, std::size_t end, unsigned) {
        multiplyBlocks(m_firstBlock + static_cast<unsigned>(begin), m_firstBlock + static_cast<unsigned>(end));
    });
}

void dxSparseRows::append(unsigned column) {
    if (isBuilt()) insertColumn(column, m_sets.countC() - 1);
}

void dxSparseRows::remove(unsigned position) {
    if (!isBuilt()) return;
    const unsigned lastPosition = m_sets.countC() - 1, last = m_sets.indexAt(lastPosition);
    eraseColumn(m_sets.indexAt(position), position);
    if (position == lastPosition) return;
    eraseColumn(last, lastPosition);
    insertColumn(last, position);
}

void dxSparseRows::insertColumn(unsigned column, unsigned position) {
    const dReal *const elements = m_A.row(column);
    forBits(pattern(column), m_patternWords, [&](unsigned block) {
        insert(m_firstBlock + block, position, elements + std::size_t(m_firstBlock + block) * kHalfLine);
    });
}

void dxSparseRows::eraseColumn(unsigned column, unsigned position) {
    forBits(pattern(column), m_patternWords, [&](unsigned block) { erase(m_firstBlock + block, position); });
}

// The first of a block's pieces that is not before the position.
unsigned dxSparseRows::findPiece(unsigned block, unsigned position) const {
    const unsigned *const positions = m_positions + m_begins[block], *const end = positions + m_counts[block];
    if (positions == end || end[-1] < position) return m_counts[block];  // most pieces come last
    return static_cast<unsigned>(std::lower_bound(positions, end, position) - positions);
}

void dxSparseRows::insert(unsigned block, unsigned position, const dReal *elements) {
    const unsigned k = findPiece(block, position), count = m_counts[block]++;
    unsigned *const positions = m_positions + m_begins[block];
    std::copy_backward(positions + k, positions + count, positions + count + 1);
    std::copy_backward(piece(block, k), piece(block, count), piece(block, count + 1));
    positions[k] = position;
    std::copy_n(elements, kHalfLine, piece(block, k));
}

void dxSparseRows::erase(unsigned block, unsigned position) {
    const unsigned k = findPiece(block, position), count = m_counts[block]--;
    unsigned *const positions = m_positions + m_begins[block];
    std::copy(positions + k + 1, positions + count, positions + k);
    std::copy(piece(block, k + 1), piece(block, count), piece(block, k));
}
