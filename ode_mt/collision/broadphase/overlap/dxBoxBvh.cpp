#include "core/dxSimdTargets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/broadphase/overlap/dxBoxBvh.cpp"
#include <hwy/foreach_target.h>
// Highway's order of headers: after foreach_target.h
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "collision/broadphase/overlap/dxBoxLanes-inl.h"
#include "collision/broadphase/overlap/dxBoxBvh.h"

#ifndef DX_BOX_BVH_CONSTANTS
#define DX_BOX_BVH_CONSTANTS
namespace dxBroadphaseKernels {
constexpr std::size_t kChildren = 8;
}  // namespace dxBroadphaseKernels
#endif

HWY_BEFORE_NAMESPACE();
namespace dxBroadphaseKernels {
namespace HWY_NAMESPACE {
// At most eight lanes, one for each child of a node.
using Lanes = hn::CappedTag<double, kChildren>;

class Query {
public:
    Query(const dxBoxBvh::Level *levels, const std::uint8_t *isThere, const double *box,
          std::pmr::vector<std::uint32_t> &rows)
        : m_levels(levels), m_isThere(isThere), m_rows(rows), m_box(box) {}

    void descend(std::size_t level, std::size_t node) {
        forLanes(overlapping(m_levels[level], node * kChildren), [&](std::size_t which) HWY_ATTR {
            const std::size_t child = node * kChildren + which;
            if (level != 0 && child * kChildren < m_levels[level - 1].size())
                descend(level - 1, child);
            else if (level == 0 && m_isThere[child])
                m_rows.push_back(static_cast<std::uint32_t>(child));
        });
    }

private:
    HWY_INLINE std::uint32_t overlapping(const dxBoxBvh::Level &level, std::size_t first) const {
        const Lanes d;
        const double *const columns[6] = {level.bounds[0].data(), level.bounds[1].data(),
                                          level.bounds[2].data(), level.bounds[3].data(),
                                          level.bounds[4].data(), level.bounds[5].data()};
        std::uint32_t together = 0;
        for (std::size_t i = 0; i < kChildren; i += hn::Lanes(d))
            together |= lanesLeft(d, m_box.apart(columns, first + i)) << i;
        return together;
    }

    const dxBoxBvh::Level *m_levels;
    const std::uint8_t *m_isThere;
    std::pmr::vector<std::uint32_t> &m_rows;
    BoxLanes<Lanes> m_box;
};

void queryBvh(const dxBoxBvh::Level *levels, std::size_t top, const std::uint8_t *isThere, const dxBounds &box,
              std::pmr::vector<std::uint32_t> &rows) {
    double bounds[6];
    std::copy(box.v, box.v + 6, bounds);
    Query(levels, isThere, bounds, rows).descend(top, 0);
}

}  // namespace HWY_NAMESPACE
}  // namespace dxBroadphaseKernels
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dxBroadphaseKernels {
HWY_EXPORT(queryBvh);

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNowhere[6] = {kInfinity, -kInfinity, kInfinity, -kInfinity, kInfinity, -kInfinity};

// Computes the box around the children of one node.
void around(const dxBoxBvh::Level &level, std::size_t first, double *box) {
    std::copy(kNowhere, kNowhere + 6, box);
    for (std::size_t i = first; i < first + kChildren; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            box[2 * axis] = std::min(box[2 * axis], level.bounds[2 * axis][i]);
            box[2 * axis + 1] = std::max(box[2 * axis + 1], level.bounds[2 * axis + 1][i]);
        }
}

}  // namespace
}  // namespace dxBroadphaseKernels

void dxBoxBvh::Level::push(const double *box) {
    for (int i = 0; i < 6; ++i) bounds[i].push_back(box[i]);
}

void dxBoxBvh::Level::fillUp() {
    while (size() % dxBroadphaseKernels::kChildren != 0) push(dxBroadphaseKernels::kNowhere);
}

void dxBoxBvh::begin() {
    for (Level &level : m_levels)
        for (std::vector<double> &bound : level.bounds) bound.clear();
    if (m_levels.empty()) m_levels.emplace_back();
    m_isThere.clear();
    m_inUse = 0;
}

void dxBoxBvh::push(const dxBounds &box) {
    double bounds[6];
    std::copy(box.v, box.v + 6, bounds);
    m_levels[0].push(bounds);
    m_isThere.push_back(1);
}

void dxBoxBvh::finish() {
    m_levels[0].fillUp();
    m_isThere.resize(m_levels[0].size(), 0);
    m_inUse = m_levels[0].size() == 0 ? 0 : 1;
    for (std::size_t below = 0; m_inUse != 0 && m_levels[below].size() > dxBroadphaseKernels::kChildren; ++below) {
        if (m_levels.size() == below + 1) m_levels.emplace_back();
        for (std::size_t first = 0; first < m_levels[below].size(); first += dxBroadphaseKernels::kChildren) {
            double box[6];
            dxBroadphaseKernels::around(m_levels[below], first, box);
            m_levels[below + 1].push(box);
        }
        m_levels[below + 1].fillUp();
        m_inUse = below + 2;
    }
}

void dxBoxBvh::erase(std::size_t row) {
    m_isThere[row] = 0;
    for (int i = 0; i < 6; ++i) m_levels[0].bounds[i][row] = dxBroadphaseKernels::kNowhere[i];
}

void dxBoxBvh::query(const dxBounds &box, std::pmr::vector<std::uint32_t> &rows) const {
    if (m_inUse != 0)
        HWY_DYNAMIC_DISPATCH(dxBroadphaseKernels::queryBvh)(m_levels.data(), m_inUse - 1, m_isThere.data(), box, rows);
}
#endif
