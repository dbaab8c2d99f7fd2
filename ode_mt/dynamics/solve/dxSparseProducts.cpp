#include "simd/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dynamics/solve/dxSparseProducts.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <algorithm>

#include "dynamics/solve/dxLineLanes-inl.h"
#include "dynamics/solve/dxSparseProducts.h"

HWY_BEFORE_NAMESPACE();
namespace dxSolve {
namespace HWY_NAMESPACE {

// Four positions are added up to one another before they are added to the sum: a line begins another group, or goes on
// with that of the line before. Which of them is as good as random, so both are done, and one is masked out.
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

// The products of one block, line by line.
template <unsigned Vectors>
class BlockProducts {
public:
    HWY_INLINE BlockProducts(const dxSparseProductsTask &task, unsigned block)
        : m_positions(task.positions + task.begins[block]),
          m_lines(task.lines + std::size_t(task.begins[block]) * kLineLanes),
          m_factors(task.factors),
          m_wholeGroups(task.count / 4) {}

    HWY_INLINE void add(unsigned k) {
        const LineTag d;
        const unsigned position = m_positions[k], group = position / 4;
        const bool beginsGroup = (group != m_group) | (group == m_wholeGroups);  // those left over are added one by one
        m_group = group;
        const auto factor = hn::Set(d, m_factors[position]);
        for (unsigned v = 0; v < Vectors; ++v)
            m_sums[v].add(hn::Mul(hn::Load(d, m_lines + k * std::size_t(kLineLanes) + v * hn::Lanes(d)), factor), beginsGroup);
    }

    HWY_INLINE void store(dReal *result) const {
        const LineTag d;
        for (unsigned v = 0; v < Vectors; ++v) hn::Store(m_sums[v].get(), d, result + v * hn::Lanes(d));
    }

private:
    const unsigned *const m_positions;
    const dReal *const m_lines, *const m_factors;
    const unsigned m_wholeGroups;
    unsigned m_group = ~0u;
    GroupedSum<LineTag> m_sums[Vectors];
};

// Two blocks side by side: each is a chain of additions, and waits for itself.
template <unsigned Vectors>
HWY_INLINE void multiplyBlocks(const dxSparseProductsTask &task, unsigned block, unsigned other) {
    BlockProducts<Vectors> products(task, block), others(task, other);
    const unsigned count = task.counts[block], otherCount = task.counts[other], both = std::min(count, otherCount);
    for (unsigned k = 0; k < both; ++k) {
        products.add(k);
        others.add(k);
    }
    for (unsigned k = both; k < count; ++k) products.add(k);
    for (unsigned k = both; k < otherCount; ++k) others.add(k);
    products.store(task.result + std::size_t(block) * kLineLanes);
    others.store(task.result + std::size_t(other) * kLineLanes);
}

HWY_INLINE unsigned nextWanted(const dxSparseProductsTask &task, unsigned block) {
    while (block < task.endBlock && task.wanted[block] == 0) ++block;
    return block;
}

void computeSparseProducts(const dxSparseProductsTask &task) {
    constexpr unsigned kVectors = kLineLanes / hn::MaxLanes(LineTag());
    for (unsigned block = nextWanted(task, task.beginBlock); block < task.endBlock;) {
        const unsigned next = nextWanted(task, block + 1), other = next < task.endBlock ? next : block;
        multiplyBlocks<kVectors>(task, block, other);
        block = nextWanted(task, other + 1);
    }
}

void markLines(const dReal *row, std::size_t lines, std::uint64_t *bits) {
    const LineTag d;
    std::fill_n(bits, (lines + 63) / 64, std::uint64_t{0});
    for (std::size_t line = 0; line < lines; ++line) {
        auto all = hn::Load(d, row + line * kLineLanes);
        for (std::size_t lane = hn::Lanes(d); lane < kLineLanes; lane += hn::Lanes(d))
            all = hn::Or(all, hn::Load(d, row + line * kLineLanes + lane));
        const bool isZero = hn::AllTrue(d, hn::Eq(hn::Abs(all), hn::Zero(d)));
        bits[line / 64] |= std::uint64_t{!isZero} << (line % 64);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace dxSolve
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxSolve {
HWY_EXPORT(computeSparseProducts);
HWY_EXPORT(markLines);
}  // namespace dxSolve

void dxComputeSparseProducts(const dxSparseProductsTask &task) {
    HWY_DYNAMIC_DISPATCH(dxSolve::computeSparseProducts)(task);
}

void dxMarkLines(const dReal *row, std::size_t lines, std::uint64_t *bits) {
    HWY_DYNAMIC_DISPATCH(dxSolve::markLines)(row, lines, bits);
}
#endif
