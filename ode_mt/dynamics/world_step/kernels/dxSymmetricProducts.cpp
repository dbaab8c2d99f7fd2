#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxSymmetricProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>

#include "dynamics/world_step/kernels/dxSymmetricProducts.h"
#include "dynamics/world_step/kernels/dxLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// --- dense -----------------------------------------------------------------------------------------------------

// Rows of the matrix are read as streams, eight at a time, and the sums kept in `result`.
constexpr unsigned kStreams = 8;

// Up to kMaxShortVectors vectors from the first lane to the last, sums are kept in registers, kSumsAtOnce at a time.
constexpr std::size_t kMaxShortVectors = 32, kSumsAtOnce = 4;

HWY_INLINE bool isVectorWanted(const dxLaneProductsTask &task, std::size_t lane) {
    const unsigned *const wanted = task.wanted + lane / kHalfLine;
    if constexpr (hn::MaxLanes(LineTag()) > kHalfLine) return (wanted[0] | wanted[1]) != 0;
    return wanted[0] != 0;
}

// result(row) += the products with Streams columns
template <unsigned Streams>
HWY_INLINE void addStreams(const dxLaneProductsTask &task, unsigned first) {
    const LineTag d;
    const dReal *stream[Streams];
    LineVector factor[Streams];
    for (unsigned k = 0; k < Streams; ++k) {
        stream[k] = task.matrix + task.columns[first + k] * task.rowSkip;
        factor[k] = hn::Set(d, task.factors[first + k]);
    }
    const std::size_t end = std::size_t(task.endBlock) * kLineLanes;
    for (std::size_t lane = std::size_t(task.beginBlock) * kLineLanes; lane < end; lane += hn::Lanes(d)) {
        if (!isVectorWanted(task, lane)) continue;
        const auto product = [&](unsigned k) { return hn::Mul(hn::Load(d, stream[k] + lane), factor[k]); };
        auto sum = hn::Load(d, task.result + lane);
        if constexpr (Streams == 1) {
            sum = hn::Add(sum, product(0));
        } else {
            for (unsigned k = 0; k < Streams; k += 4)
                sum = hn::Add(sum, hn::Add(hn::Add(hn::Add(product(k), product(k + 1)), product(k + 2)),
                                           product(k + 3)));
        }
        hn::Store(sum, d, task.result + lane);
    }
}

// The sums of the vectors that begin at `lanes`, over all columns.
template <std::size_t Vectors>
HWY_INLINE void sumInRegisters(const dxLaneProductsTask &task, const std::size_t *lanes) {
    const LineTag d;
    std::size_t lane[Vectors];
    LineVector sum[Vectors];
    for (std::size_t v = 0; v < Vectors; ++v) {
        lane[v] = lanes[v];
        sum[v] = hn::Zero(d);
    }
    const auto stream = [&](unsigned k) { return task.matrix + task.columns[k] * task.rowSkip; };
    unsigned k = 0;
    for (; k + 4 <= task.count; k += 4) {
        const dReal *const streams[4] = {stream(k), stream(k + 1), stream(k + 2), stream(k + 3)};
        LineVector factor[4];
        for (unsigned i = 0; i < 4; ++i) factor[i] = hn::Set(d, task.factors[k + i]);
        for (std::size_t v = 0; v < Vectors; ++v) {
            const auto product = [&](unsigned i) { return hn::Mul(hn::Load(d, streams[i] + lane[v]), factor[i]); };
            sum[v] = hn::Add(sum[v], hn::Add(hn::Add(hn::Add(product(0), product(1)), product(2)), product(3)));
        }
    }
    for (; k < task.count; ++k) {
        const dReal *const single = stream(k);
        const LineVector factor = hn::Set(d, task.factors[k]);
        for (std::size_t v = 0; v < Vectors; ++v)
            sum[v] = hn::Add(sum[v], hn::Mul(hn::Load(d, single + lane[v]), factor));
    }
    for (std::size_t v = 0; v < Vectors; ++v) hn::Store(sum[v], d, task.result + lane[v]);
}

// Which vectors are wanted is as good as random: they are listed first, without a branch.
HWY_INLINE void computeShort(const dxLaneProductsTask &task) {
    std::size_t lanes[kMaxShortVectors + 1], count = 0;
    const std::size_t end = std::size_t(task.endBlock) * kLineLanes;
    for (std::size_t lane = std::size_t(task.beginBlock) * kLineLanes; lane < end; lane += hn::Lanes(LineTag())) {
        lanes[count] = lane;
        count += isVectorWanted(task, lane);
    }
    std::size_t done = 0;
    for (; done + kSumsAtOnce <= count; done += kSumsAtOnce) sumInRegisters<kSumsAtOnce>(task, lanes + done);
    switch (count - done) {
    case 3: return sumInRegisters<3>(task, lanes + done);
    case 2: return sumInRegisters<2>(task, lanes + done);
    case 1: return sumInRegisters<1>(task, lanes + done);
    }
}

void computeLaneProducts(const dxLaneProductsTask &task) {
    const LineTag d;
    const std::size_t begin = std::size_t(task.beginBlock) * kLineLanes, end = std::size_t(task.endBlock) * kLineLanes;
    if (end - begin <= kMaxShortVectors * hn::Lanes(d)) return computeShort(task);
    for (std::size_t lane = begin; lane < end; lane += hn::Lanes(d)) hn::Store(hn::Zero(d), d, task.result + lane);
    unsigned k = 0;
    for (; k + kStreams <= task.count; k += kStreams) addStreams<kStreams>(task, k);
    if (k + 4 <= task.count) {
        addStreams<4>(task, k);
        k += 4;
    }
    for (; k < task.count; ++k) addStreams<1>(task, k);
}

// --- sparse ----------------------------------------------------------------------------------------------------

using PieceTag = RowLanes<kHalfLine>;

// Four positions are added up to one another before they are added to the sum: a piece begins another group, or goes on
// with that of the piece before. Which of them is unpredictable, so both are computed, and one is masked out.
template <class D>
class GroupedSum {
public:
    using Lanes = hn::Vec<D>;

    HWY_INLINE GroupedSum() : m_before(hn::Zero(D())), m_group(hn::Zero(D())) {}

    HWY_INLINE void add(Lanes product, bool beginsGroup) {
        const D d;
        const hn::RebindToSigned<D> bits;
        const auto begins = hn::BitCast(d, hn::Set(bits, -static_cast<hn::TFromD<decltype(bits)>>(beginsGroup)));
        m_before = hn::Add(m_before, hn::And(begins, m_group));
        m_group = hn::Add(hn::AndNot(begins, m_group), product);
    }
    HWY_INLINE Lanes get() const { return hn::Add(m_before, m_group); }

private:
    Lanes m_before, m_group;
};

// The products of one block, piece by piece.
template <unsigned Vectors>
class BlockProducts {
public:
    HWY_INLINE BlockProducts(const dxSparseProductsTask &task, unsigned block)
        : m_positions(task.positions + task.begins[block]),
          m_pieces(task.pieces + std::size_t(task.begins[block]) * kHalfLine),
          m_factors(task.factors),
          m_wholeGroups(task.count / 4) {}

    HWY_INLINE void add(unsigned k) {
        const PieceTag d;
        const unsigned position = m_positions[k], group = position / 4;
        const bool beginsGroup = (group != m_group) | (group == m_wholeGroups);  // those left over are added one by one
        m_group = group;
        const auto factor = hn::Set(d, m_factors[position]);
        for (unsigned v = 0; v < Vectors; ++v)
            m_sums[v].add(hn::Mul(hn::Load(d, m_pieces + k * std::size_t(kHalfLine) + v * hn::Lanes(d)), factor), beginsGroup);
    }

    HWY_INLINE void store(dReal *result) const {
        const PieceTag d;
        for (unsigned v = 0; v < Vectors; ++v) hn::Store(m_sums[v].get(), d, result + v * hn::Lanes(d));
    }

private:
    const unsigned *const m_positions;
    const dReal *const m_pieces, *const m_factors;
    const unsigned m_wholeGroups;
    unsigned m_group = ~0u;
    GroupedSum<PieceTag> m_sums[Vectors];
};

// Blocks side by side: each is a chain of additions, and waits for itself.
constexpr unsigned kSideBySide = 4;

template <unsigned Vectors>
HWY_INLINE void multiplyBlocks(const dxSparseProductsTask &task, const unsigned (&blocks)[kSideBySide]) {
    BlockProducts<Vectors> products[kSideBySide] = {{task, blocks[0]}, {task, blocks[1]}, {task, blocks[2]}, {task, blocks[3]}};
    unsigned all = ~0u;
    for (const unsigned block : blocks) all = std::min(all, task.counts[block]);
    for (unsigned k = 0; k < all; ++k) {
        products[0].add(k);
        products[1].add(k);
        products[2].add(k);
        products[3].add(k);
    }
    for (unsigned i = 0; i < kSideBySide; ++i) {
        for (unsigned k = all; k < task.counts[blocks[i]]; ++k) products[i].add(k);
        products[i].store(task.result + std::size_t(blocks[i]) * kHalfLine);
    }
}

HWY_INLINE unsigned nextWanted(const dxSparseProductsTask &task, unsigned block) {
    while (block < task.endBlock && task.wanted[block] == 0) ++block;
    return block;
}

void computeSparseProducts(const dxSparseProductsTask &task) {
    constexpr unsigned kVectors = kHalfLine / hn::MaxLanes(PieceTag());
    for (unsigned block = nextWanted(task, task.beginBlock); block < task.endBlock;) {
        unsigned blocks[kSideBySide];
        for (unsigned &own : blocks) {
            own = block;
            const unsigned next = nextWanted(task, block + 1);
            if (next < task.endBlock) block = next;
        }
        multiplyBlocks<kVectors>(task, blocks);
        if (block == blocks[kSideBySide - 1]) break;
    }
}

void markPieces(const dReal *row, std::size_t pieces, std::uint64_t *bits) {
    const PieceTag d;
    std::fill_n(bits, (pieces + 63) / 64, std::uint64_t{0});
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        bool isZero = true;
        for (std::size_t lane = 0; lane < kHalfLine; lane += hn::Lanes(d))
            isZero &= hn::AllTrue(d, hn::Eq(hn::Load(d, row + piece * kHalfLine + lane), hn::Zero(d)));
        bits[piece / 64] |= std::uint64_t{!isZero} << (piece % 64);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(computeLaneProducts);
HWY_EXPORT(computeSparseProducts);
HWY_EXPORT(markPieces);
}  // namespace dxSolve

void dxComputeLaneProducts(const dxLaneProductsTask &task) {
    HWY_DYNAMIC_DISPATCH(dxSolve::computeLaneProducts)(task);
}

void dxComputeSparseProducts(const dxSparseProductsTask &task) {
    HWY_DYNAMIC_DISPATCH(dxSolve::computeSparseProducts)(task);
}

void dxMarkPieces(const dReal *row, std::size_t pieces, std::uint64_t *bits) {
    HWY_DYNAMIC_DISPATCH(dxSolve::markPieces)(row, pieces, bits);
}
#endif
