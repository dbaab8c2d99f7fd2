#include "dynamics/quick_step/fast/dxRowOrder.h"

#include <utility>

#include "core/dxMixedBits.h"
#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/quick_step/sor/dxSorOrder.h"

namespace {

using Row = dxConstraintRow;

// With upstream's eight, and the last sweeps not over-relaxed, a chain of motors sags by 2 % more. Twelve leave a deck on joints with
// residuals that are a third larger.
constexpr unsigned kSweepsPerOrder = 9;

}  // namespace

void dxRowOrder::reserve(std::size_t joints, std::size_t rows, dxStepArena &arena) {
    m_rows = arena.takeList<int>(rows);
    m_first = arena.takeList<unsigned>(joints + 1);
}

void dxRowOrder::make(const dxConstraintPlan &plan, dxArenaArray<const unsigned> firstRow, const Row *rows) {
    const bool isUpstreams = !plan.hasContactsOnly();
    m_isSerial = plan.hasSerialRows();
    m_seed = 0;
    const dxArenaArray<const unsigned> joints = plan.rowJointsInOrder();
    m_first.clear();
    m_first.push(0);
    for (const unsigned joint : joints) m_first.push(m_first.back() + firstRow[joint + 1] - firstRow[joint]);
    m_rows.clear();
    const auto take = [&](const dxConstraintPlan::Chunk &chunk, const auto &takes) {
        for (unsigned i = chunk.firstRowJoint; i < chunk.endRowJoint; ++i)
            for (unsigned row = firstRow[joints[i]]; row < firstRow[joints[i] + 1]; ++row)
                if (takes(rows[row])) m_rows.push(static_cast<int>(row));
    };
    for (const dxConstraintPlan::Chunk &chunk : plan.chunks()) {
        if (isUpstreams) {
            take(chunk, [](const Row &row) { return !row.hasFrictionIndex(); });
            take(chunk, [](const Row &row) { return row.hasFrictionIndex(); });
        } else {
            take(chunk, [](const Row &) { return true; });
        }
    }
}

// FNV-1a mixes bytes in this way (G. Fowler, L. C. Noll, K.-P. Vo). shuffle() makes random numbers of the result.
void dxRowOrder::mix(double number) { m_seed = (m_seed ^ dxStateNumbers::bitsOf(number)) * 0x100000001b3u; }

void dxRowOrder::schedule(dxIslandProblem problem) {
    if (!m_isSerial) return;
    problem.rowCount = static_cast<unsigned>(m_rows.size());
    problem.order = m_rows.data();
    dxScheduleSor(problem);
}

dxArenaArray<const int> dxRowOrder::of(unsigned begin, unsigned end) const {
    return {m_rows.data() + m_first[begin], m_first[end] - m_first[begin]};
}

dxArenaArray<const int> dxRowOrder::inSweep(unsigned begin, unsigned end, unsigned sweep) {
    if (sweep > 1 && sweep % kSweepsPerOrder == 1) shuffle(m_first[begin], m_first[end], sweep);
    return of(begin, end);
}

// Chunks are shuffled separately, so that the order does not depend on who solves them.
void dxRowOrder::shuffle(unsigned first, unsigned last, unsigned sweep) {
    std::uint64_t bits = dxMixedBits(m_seed ^ first ^ std::uint64_t(sweep) << 32);
    for (unsigned i = last; i > first + 1; --i) {
        bits += kMixedBitsStep;
        std::swap(m_rows[i - 1], m_rows[first + dxStateNumbers::below(dxMixedBits(bits), i - first)]);
    }
}
