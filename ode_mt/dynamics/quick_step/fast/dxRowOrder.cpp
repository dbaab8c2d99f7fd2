#include "dynamics/quick_step/fast/dxRowOrder.h"

#include <utility>

#include "core/dxMixedBits.h"
#include "core/dxReserve.h"
#include "dynamics/quick_step/fast/dxStateNumbers.h"
#include "dynamics/quick_step/sor/dxSorSweep.h"

namespace {

using Row = dxConstraintRow;

// With upstream's eight, and the last sweeps not over-relaxed, a chain of motors sags by 2 % more. Twelve leave a deck on joints with
// residuals that are a third larger.
constexpr unsigned kSweepsPerOrder = 9;

}  // namespace

void dxRowOrder::reserve(std::size_t joints, std::size_t rows) {
    m_rows.reserve(rows);
    m_first.reserve(joints + 1);
}

void dxRowOrder::reserveAs(const dxRowOrder &other) {
    m_rows.reserve(other.m_rows.capacity());
    m_first.reserve(other.m_first.capacity());
}

void dxRowOrder::make(const dxConstraintPlan &plan, const std::vector<unsigned> &firstRow, const Row *rows) {
    const bool isUpstreams = !plan.hasContactsOnly();
    m_isSerial = plan.hasSerialRows();
    m_seed = 0;
    const std::vector<unsigned> &joints = plan.othersInOrder();
    dxFill(m_first, joints.size() + 1, 0);
    for (std::size_t i = 0; i < joints.size(); ++i) m_first[i + 1] = m_first[i] + firstRow[joints[i] + 1] - firstRow[joints[i]];
    m_rows.clear();
    const auto take = [&](const dxConstraintPlan::Chunk &chunk, const auto &takes) {
        for (unsigned i = chunk.firstOther; i < chunk.endOther; ++i)
            for (unsigned row = firstRow[joints[i]]; row < firstRow[joints[i] + 1]; ++row)
                if (takes(rows[row])) m_rows.push_back(static_cast<int>(row));
    };
    for (const dxConstraintPlan::Chunk &chunk : plan.chunks()) {
        if (isUpstreams) {
            take(chunk, [](const Row &row) { return !row.isBounded(); });
            take(chunk, [](const Row &row) { return row.isBounded(); });
        } else {
            take(chunk, [](const Row &) { return true; });
        }
    }
}

// As FNV-1a mixes bytes (G. Fowler, L. C. Noll, K.-P. Vo); shuffle() makes random numbers of it.
void dxRowOrder::mix(double number) { m_seed = (m_seed ^ dxStateNumbers::bitsOf(number)) * 0x100000001b3u; }

void dxRowOrder::schedule(dxIslandProblem problem) {
    if (!m_isSerial) return;
    problem.rowCount = static_cast<unsigned>(m_rows.size());
    problem.order = m_rows.data();
    dxScheduleSor(problem);
}

dxRowOrder::Rows dxRowOrder::of(unsigned begin, unsigned end) const {
    return {m_rows.data() + m_first[begin], m_rows.data() + m_first[end]};
}

dxRowOrder::Rows dxRowOrder::inSweep(unsigned begin, unsigned end, unsigned sweep) {
    if (sweep > 1 && sweep % kSweepsPerOrder == 1) shuffle(m_first[begin], m_first[end], sweep);
    return of(begin, end);
}

// Chunks are shuffled apart, so that the order does not depend on who solves them.
void dxRowOrder::shuffle(unsigned first, unsigned last, unsigned sweep) {
    std::uint64_t bits = dxMixedBits(m_seed ^ first ^ std::uint64_t(sweep) << 32);
    for (unsigned i = last; i > first + 1; --i) {
        bits += kMixedBitsStep;
        std::swap(m_rows[i - 1], m_rows[first + dxStateNumbers::below(dxMixedBits(bits), i - first)]);
    }
}
