#include "collision/spaces/sweep_and_prune/dxSapWalk.h"

#include <algorithm>
#include <cmath>

#include "collision/spaces/dxPairDelivery.h"
#include "seams/assertions.h"

namespace {

// Delivers one pair as upstream does. Returns whether bits and bodies let it pass.
bool deliverPair(dxGeom *g1, dxGeom *g2, void *data, dNearCallback *callback) {
    dxSapWalk::requireCleanBoxes(g1, g2);
    return dxDeliverIfAgreed(g1, g2, data, callback);
}

}  // namespace

// Raises upstream's assertion for the first or the second geom of a pair.
void dxSapWalk::reportUncleanBox(bool isFirst) {
    dxFailUpstreamAssertion(isFirst ? "(g1->gflags & GEOM_AABB_BAD)==0" : "(g2->gflags & GEOM_AABB_BAD)==0", "collideGeomsNoAABBs",
                            "collision_sapspace.cpp", isFirst ? kSapFirstBoxLine : kSapSecondBoxLine);
}

void dxSapWalk::begin(std::size_t geoms) {
    m_swept.clear();
    m_infinite.clear();
    m_boxes.clear();
    m_keys.clear();
    m_found = 0;
    m_swept.reserve(geoms);
    m_boxes.reserve(geoms);
    m_keys.reserve(geoms);
    m_comparisons = 0;
    m_hasNaN = false;
}

void dxSapWalk::add(dxGeom *geom) {
    dxSapBox &box = m_boxes.emplace_back();
    m_axes.readBox(geom, box);
    if (box.isInfinite) {
        m_boxes.pop_back();
        m_infinite.push_back(geom);
        return;
    }
    m_swept.push_back(geom);
    m_keys.push_back(box.low);
    m_hasNaN = m_hasNaN || std::isnan(box.low);
}

void dxSapWalk::add(dxGeom *geom, const dxSapBox &box) {
    m_swept.push_back(geom);
    m_boxes.push_back(box);
}

void dxSapWalk::findPairs(dxSapSort &sort) {
    if (m_swept.empty()) return;
    const std::vector<std::uint32_t> &order = sort.sort(m_keys);
    m_hasNaN ? sweepAsUpstream(order) : sweep(order);
}

// Copies the boxes so that they are in order in memory. There is no branch on whether two boxes overlap, as it would be mispredicted.
void dxSapWalk::sweep(const std::vector<std::uint32_t> &order) {
    m_sorted.resize(order.size());
    for (std::size_t place = 0; place < order.size(); ++place) m_sorted[place] = m_boxes[order[place]];
    for (std::size_t place = 0; place < order.size(); ++place) {
        const dxSapBox &box = m_sorted[place];
        if (m_pairs.size() < m_found + order.size()) m_pairs.resize(2 * (m_found + order.size()));
        std::size_t later = place + 1;
        for (; later < order.size() && m_sorted[later].low <= box.high; ++later) {
            m_pairs[m_found] = {order[place], order[later]};
            m_found += box.meetsAcross(m_sorted[later]);
        }
        m_comparisons += later - place - 1;
    }
}

// Upstream keeps a second index, which it advances until it is behind a key that is not below the current geom's key. Along rising keys that key is
// the current geom's own. With NaN it is not: every comparison with NaN is false, so the index stops at NaN.
void dxSapWalk::sweepAsUpstream(const std::vector<std::uint32_t> &order) {
    m_pairs.clear();
    auto next = order.begin();
    for (const std::uint32_t earlier : order) {
        const float key = m_keys[earlier];
        next = std::find_if(next, order.end(), [&](std::uint32_t other) { return !(m_keys[other] < key); });
        if (next == order.end() || ++next == order.end()) break;
        auto later = next;
        for (; later != order.end() && m_keys[*later] <= m_boxes[earlier].high; ++later)
            if (m_boxes[earlier].meetsAcross(m_boxes[*later])) m_pairs.push_back({earlier, *later});
        m_comparisons += static_cast<std::size_t>(later - next);
    }
    m_found = m_pairs.size();
}

// As in upstream, the indices of a pair mean entries of the lists when the pair's turn comes. The sizes of the lists are read once, when the pairs of
// infinite geoms begin.
void dxSapWalk::deliver(void *data, dNearCallback *callback, const dxSapTemporaryLists &lists, unsigned fills, const dxOrderedPair *after) {
    const auto sweptAt = [&](std::size_t i) { return lists.fills() == fills ? m_swept[i] : lists.swept()[i]; };
    const auto infiniteAt = [&](std::size_t i) { return lists.fills() == fills ? m_infinite[i] : lists.infinite()[i]; };
    const auto isDone = [&](const dxGeom *first, const dxGeom *second) {
        if (after == nullptr) return false;
        if (first == after->first && second == after->second) after = nullptr;
        return true;
    };
    std::size_t wanted = 0;
    for (std::size_t i = 0; i < m_found; ++i) {
        const Pair &pair = m_pairs[i];
        if (isDone(m_swept[pair.earlier], m_swept[pair.later])) continue;
        wanted += deliverPair(sweptAt(pair.earlier), sweptAt(pair.later), data, callback);
    }
    m_wanted = wanted;
    const bool areRefilled = lists.fills() != fills && after == nullptr;
    const std::size_t swept = areRefilled ? lists.sweptSize() : m_swept.size();
    const std::size_t infinite = areRefilled ? lists.infiniteSize() : m_infinite.size();
    for (std::size_t i = 0; i < infinite; ++i) {
        dxGeom *const first = after != nullptr ? m_infinite[i] : infiniteAt(i);  // as in upstream, read before its partners
        for (std::size_t j = i + 1; j < infinite; ++j) {
            if (after != nullptr && isDone(m_infinite[i], m_infinite[j])) continue;
            deliverPair(first, infiniteAt(j), data, callback);
        }
        for (std::size_t j = 0; j < swept; ++j) {
            if (after != nullptr && isDone(m_infinite[i], m_swept[j])) continue;
            deliverPair(first, sweptAt(j), data, callback);
        }
    }
}
