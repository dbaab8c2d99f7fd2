#include "collision/dxOrderedSimpleSpace.h"

#include <algorithm>

#include "util.h"
#include "collision_space_internal.h"

namespace {

// Up to this many geoms comparing boxes by vectors is faster than keeping neighbours and sorting, whatever
// share of them moves (docs/collision-order.md has the figures). A space on the border does not go back and
// forth: it turns dense again at half of it.
constexpr int kLargestDense = 512;

}  // namespace

void dxOrderedSimpleSpace::collide(void *data, dNearCallback *callback) {
    dAASSERT(callback);
    beginCollide();
    if (makeReady())
        collidePairs(data, callback);
    else
        collideList(data, callback);
    lock_count--;
}

void dxOrderedSimpleSpace::update(std::vector<dxOrderedPair> &pairs) {
    const bool dense = !hasSearch() && count <= (m_dense != nullptr ? kLargestDense : kLargestDense / 2);
    if (dense != (m_dense != nullptr)) {
        m_dense.reset(dense ? new dxDensePairs : nullptr);
        startAnew();
    }
    if (dense)
        m_dense->update(members(), pairs);
    else
        dxOrderedSpace::update(pairs);
}

bool dxOrderedSimpleSpace::place(Slot a, Slot b, dxPairKey &key, bool &swapped) const {
    const dxRank rankA = members()[a].rank, rankB = members()[b].rank;
    swapped = rankA < rankB;
    key.words = {dxFrontFirst(std::max(rankA, rankB)), dxFrontFirst(std::min(rankA, rankB)), 0, 0};
    return true;
}

void dxOrderedSimpleSpace::expect(Slot a, Slot b) const {
    members().expect(a);
    members().expect(b);
}

// Upstream asks whether a geom is enabled once before it is paired with those behind it, and of each of
// those when its turn comes. A callback may enable or disable either.
void dxOrderedSimpleSpace::collidePairs(void *data, dNearCallback *callback) {
    const dxGeom *front = nullptr;
    bool frontIsEnabled = false;
    dxContactsAhead *const ahead = this->ahead();
    for (std::size_t i = 0; i < pairs().size(); ++i) {
        const dxOrderedPair &pair = pairs()[i];
        if (pair.first != front) {
            front = pair.first;
            frontIsEnabled = dxGeomIsEnabled(front);
        }
        if (!frontIsEnabled || !dxGeomIsEnabled(pair.second)) continue;
        if (ahead != nullptr) ahead->beforePair(pairs(), i);
        dxDeliver(pair, data, callback);
    }
}

void dxOrderedSimpleSpace::collideList(void *data, dNearCallback *callback) {
    for (dxGeom *g1 = first; g1 != nullptr; g1 = g1->next) {
        if (!dxGeomIsEnabled(g1)) continue;
        for (dxGeom *g2 = g1->next; g2 != nullptr; g2 = g2->next)
            if (dxGeomIsEnabled(g2)) collideAABBs(g1, g2, data, callback);
    }
}
