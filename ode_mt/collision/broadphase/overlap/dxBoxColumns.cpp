#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/broadphase/overlap/dxBoxColumns.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>

#include "collision/broadphase/overlap/dxBoxLanes-inl.h"
#include "collision/broadphase/overlap/dxBoxColumns.h"

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {
using RealLanes = hn::ScalableTag<dReal>;

struct Columns {
    const dReal *bounds[6];
    explicit Columns(const dxBoxColumns &table) {
        for (int bound = 0; bound < 6; ++bound) bounds[bound] = table.column(bound);
    }
};

// Calls visit(row, lanes) for the rows from `begin` to `end`, a vector at a time, with a bit for each that overlaps the box.
template <class Visit>
HWY_INLINE void visitOverlapping(const Columns &columns, const BoxLanes<RealLanes> &box, std::size_t begin,
                                 std::size_t end, Visit &&visit) {
    const RealLanes d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t row = begin;
    for (; row + lanes <= end; row += lanes)
        visit(static_cast<std::uint32_t>(row), lanesLeft(d, box.apart(columns.bounds, row)));
    if (row < end) visit(static_cast<std::uint32_t>(row), lanesLeft(d, box.apart(columns.bounds, row), end - row));
}

std::size_t overlappingRows(const dxBoxColumns &table, const dxBounds &box, std::size_t first, std::size_t end,
                            std::uint32_t *HWY_RESTRICT rows) {
    const std::size_t lanes = hn::Lanes(RealLanes());
    const std::uint32_t all = (std::uint32_t{1} << lanes) - 1;
    std::size_t count = 0;
    visitOverlapping(Columns(table), BoxLanes<RealLanes>(box.v), first, end,
                     [&](std::uint32_t row, std::uint32_t overlapping) HWY_ATTR {
        if (overlapping == all) {  // many boxes in one place
            storeRows(row, lanes, rows + count);
            count += lanes;
        } else {
            forLanes(overlapping, [&](std::size_t lane) HWY_ATTR { rows[count++] = row + static_cast<std::uint32_t>(lane); });
        }
    });
    return count;
}

dxOverlappingRowsKernel kernelOfOverlappingRows() { return overlappingRows; }

// There is no call within the loops: it would spill the box from the registers.
std::size_t overlappingPairs(const dxBoxColumns &table, std::size_t end, std::vector<dxSlotPair> &pairs) {
    const Columns columns(table);
    std::size_t count = 0;
    for (std::uint32_t row = 0; row < end; ++row) {
        if (pairs.size() < count + table.size()) pairs.resize(2 * count + table.size());
        dxSlotPair *HWY_RESTRICT const found = pairs.data();
        visitOverlapping(columns, BoxLanes<RealLanes>(columns.bounds, row), row + 1, table.size(),
                         [&](std::uint32_t other, std::uint32_t overlapping) HWY_ATTR {
            forLanes(overlapping,
                     [&](std::size_t lane) HWY_ATTR { found[count++] = {row, other + static_cast<std::uint32_t>(lane)}; });
        });
    }
    return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
// Makes room for half as many again, and at first for a small space.
void dxBoxColumns::grow() {
    const std::size_t capacity = m_capacity + m_capacity / 2 + 2 * kPadding;
    std::vector<dReal> bounds(6 * capacity);
    for (std::size_t bound = 0; bound < 6; ++bound)
        std::copy_n(m_bounds.data() + bound * m_capacity, m_size, bounds.data() + bound * capacity);
    m_bounds.swap(bounds);
    m_capacity = capacity;
}

namespace dxBroadphaseKernels {
HWY_EXPORT(overlappingRows);
HWY_EXPORT(kernelOfOverlappingRows);
HWY_EXPORT(overlappingPairs);
}  // namespace dxBroadphaseKernels

std::size_t dxOverlappingRows(const dxBoxColumns &table, const dxBounds &box, std::size_t first, std::size_t end,
                              std::uint32_t *rows) {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::overlappingRows)(table, box, first, end, rows);
}

dxOverlappingRowsKernel dxKernelOfOverlappingRows() {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::kernelOfOverlappingRows)();
}

std::size_t dxOverlappingPairs(const dxBoxColumns &table, std::size_t end, std::vector<dxSlotPair> &pairs) {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::overlappingPairs)(table, end, pairs);
}
#endif
