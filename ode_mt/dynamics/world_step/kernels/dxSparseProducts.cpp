#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/world_step/kernels/dxSparseProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>

#include "dynamics/world_step/kernels/dxSparseProducts.h"
#include "core/dxCacheLine.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using PieceTag = hn::CappedTag<dReal, kHalfLine>;

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
HWY_EXPORT(computeSparseProducts);
HWY_EXPORT(markPieces);
}  // namespace dxSolve

void dxComputeSparseProducts(const dxSparseProductsTask &task) {
    HWY_DYNAMIC_DISPATCH(dxSolve::computeSparseProducts)(task);
}

void dxMarkPieces(const dReal *row, std::size_t pieces, std::uint64_t *bits) {
    HWY_DYNAMIC_DISPATCH(dxSolve::markPieces)(row, pieces, bits);
}
#endif
