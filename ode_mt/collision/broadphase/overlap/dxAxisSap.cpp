#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/broadphase/overlap/dxAxisSap.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>

#include "collision/broadphase/overlap/dxAxisSap.h"
#include "collision/broadphase/overlap/dxBoxLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {
using AxisLanes = hn::ScalableTag<double>;

// A row that is compared with the rows behind it.
class AxisProbe {
public:
    AxisProbe(const dxSapColumns &rows, std::size_t row) : m_rows(rows) {
        for (int i = 0; i < dxSapColumns::kColumns; ++i) m_own[i] = hn::Set(AxisLanes(), rows.column(i)[row]);
    }

    // Returns a bit for each of `valid` rows from `first` on that it meets. Sets `continues` if none of the vector's rows begins above it.
    HWY_INLINE std::uint32_t meet(std::size_t first, std::size_t valid, bool &continues) const {
        const AxisLanes d;
        const auto begun = hn::Le(at(dxSapColumns::low, first), m_own[dxSapColumns::high]);
        continues = hn::AllTrue(d, begun);
        const auto across1 = across(dxSapColumns::low1, dxSapColumns::high1, first);
        const auto across2 = across(dxSapColumns::low2, dxSapColumns::high2, first);
        return lanesLeft(d, hn::Not(hn::And(begun, hn::And(across1, across2))), valid);
    }

private:
    HWY_INLINE hn::Vec<AxisLanes> at(int column, std::size_t row) const {
        return hn::LoadU(AxisLanes(), m_rows.column(column) + row);
    }
    HWY_INLINE hn::Mask<AxisLanes> across(int low, int high, std::size_t first) const {
        return hn::And(hn::Ge(m_own[high], at(low, first)), hn::Ge(at(high, first), m_own[low]));
    }

    const dxSapColumns &m_rows;
    hn::Vec<AxisLanes> m_own[dxSapColumns::kColumns];
};

dxSapMeetings meetBehind(const dxSapColumns &rows, std::size_t row, std::uint32_t *HWY_RESTRICT met) {
    const std::size_t size = rows.size(), lanes = hn::Lanes(AxisLanes());
    const AxisProbe probe(rows, row);
    std::size_t count = 0, first = row + 1;
    for (bool continues = true; continues && first < size; first += lanes)
        forLanes(probe.meet(first, std::min(lanes, size - first), continues),
                 [&](std::size_t lane) HWY_ATTR { met[count++] = static_cast<std::uint32_t>(first + lane); });
    return {count, first - row - 1};
}

dxMeetBehindKernel kernelOfMeetBehind() { return meetBehind; }

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxBroadphaseKernels {
HWY_EXPORT(kernelOfMeetBehind);
}  // namespace dxBroadphaseKernels

void dxSapColumns::resize(std::size_t rows) {
    constexpr std::size_t kWidest = 8;                    // doubles in a vector
    if (m_columns[kColumns - 1].size() < rows + kWidest)  // the last to grow, if memory has run out before
        for (std::vector<double> &column : m_columns) column.resize(rows + rows / 2 + kWidest);
    m_size = rows;
}

dxMeetBehindKernel dxKernelOfMeetBehind() {
    return HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::kernelOfMeetBehind)();
}
#endif
