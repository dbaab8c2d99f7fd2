#include "collision/spaces/dxSapWalk.h"

#include <algorithm>

#include "collision/spaces/dxOrderedSpace.h"
#include "collision/spaces/dxUpstreamAssertion.h"
#include "seams/assertions.h"

namespace {

void deliverPair(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback) {
    dxSapWalk::requireCleanBoxes(g1, g2);
    if (dxFiltersAgree(dxFilterOf(g1), dxFilterOf(g2))) dxDeliver({g1, g2, {}}, data, callback);
}

}  // namespace

void dxSapWalk::requireUnlocked(const dxSpace &space) {
    if (space.lock_count != 0)
        dDebug(d_ERR_UASSERT, "Invalid operation for locked space in %s()", "~dxSAPSpace");
}

// Of the first of a pair's geoms, or of the second.
void dxSapWalk::reportUncleanBox(bool isFirst) {
    dxFailUpstreamAssertion(isFirst ? "(g1->gflags & GEOM_AABB_BAD)==0" : "(g2->gflags & GEOM_AABB_BAD)==0", "collideGeomsNoAABBs",
                            "collision_sapspace.cpp", isFirst ? kSapFirstBoxLine : kSapSecondBoxLine);
}

void dxSapWalk::begin(std::size_t geoms) {
    m_swept.clear();
    m_infinite.clear();
    m_boxes.clear();
    m_keys.clear();
    m_pairs.clear();
    m_swept.reserve(geoms);
    m_boxes.reserve(geoms);
    m_keys.reserve(geoms);
    m_comparisons = 0;
}

void dxSapWalk::add(dxGeom *geom) {
    const dxSapBox box = m_axes.boxOf(geom);
    if (box.isInfinite) {
        m_infinite.push_back(geom);
        return;
    }
    m_swept.push_back(geom);
    m_boxes.push_back(box);
    m_keys.push_back(box.low);
}

void dxSapWalk::findPairs(dxSapSort &sort) {
    if (!m_swept.empty()) sweep(sort.sort(m_keys));
}

// Upstream keeps a second place that runs on until it is past a key that is not below that of the geom whose turn it is.
// Along keys that rise that is the geom itself. A NaN is not below anything and nothing below it, so it ends
// whatever meets it.
void dxSapWalk::sweep(const std::vector<std::uint32_t> &order) {
    auto next = order.begin();
    for (const std::uint32_t earlier : order) {
        const float key = m_keys[earlier];
        next = std::find_if(next, order.end(), [&](std::uint32_t other) { return !(m_keys[other] < key); });
        if (next == order.end() || ++next == order.end()) return;
        auto later = next;
        for (; later != order.end() && m_keys[*later] <= m_boxes[earlier].high; ++later)
            if (m_boxes[earlier].meetsAcross(m_boxes[*later])) m_pairs.push_back({earlier, *later});
        m_comparisons += static_cast<std::size_t>(later - next);
    }
}

void dxSapWalk::deliver(void *data, dNearCallback *callback) const {
    for (const Pair &pair : m_pairs) deliverPair(m_swept[pair.earlier], m_swept[pair.later], data, callback);
    for (std::size_t i = 0; i < m_infinite.size(); ++i) {
        for (std::size_t j = i + 1; j < m_infinite.size(); ++j)
            deliverPair(m_infinite[i], m_infinite[j], data, callback);
        for (dxGeom *const other : m_swept) deliverPair(m_infinite[i], other, data, callback);
    }
}
