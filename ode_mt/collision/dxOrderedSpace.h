// A collision space that finds its pairs incrementally and calls back in the order of upstream's space of
// the same kind, which tests all pairs anew at each call.
//
// Between two calls of dSpaceCollide it keeps the list of pairs whose boxes overlap, in order. A call costs
// what has changed since the last one, plus one callback per pair.
//
// Invariants, after refresh():
//  - every geom of the space is a member with a rank. Upstream moves a geom to the front of its list when it
//    changes, and only then, so old ranks stay comparable and only changed geoms need new ones;
//  - pairs() holds, in order, exactly the pairs for which upstream's collideAABBs passes its tests of body,
//    bits and boxes and which upstream's space would bring to it. None of these can change while the space
//    is locked, which it is while callbacks run. Whether geoms are enabled can, so that is tested when
//    upstream tests it.
//
// The list itself (dxSpace::first) is upstream's, with upstream's order, locks and messages.
// One thread at a time, as upstream. docs/collision-order.md.
#pragma once

#include <vector>

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "collision/dxMembers.h"
#include "collision/dxOrderedPair.h"

class dxOrderedSpace : public dxSpace {
public:
    using Slot = dxMembers::Slot;

    // The space that a geom is in, if it is of this class, or NULL.
    static dxOrderedSpace *of(const dxGeom *geom);

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) override;
    void remove(dxGeom *geom) override;
    void cleanGeoms() override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // The category bits, collide bits or body of a member changed, which moves nothing.
    void filtersChanged(dxGeom *geom) { m_members.markChanged(slotOf(geom)); }

protected:
    explicit dxOrderedSpace(dSpaceID parent, int type);

    // Brings pairs() up to date. False: upstream's list is not in the state in which ranks stand for it, and
    // the caller has to walk the list as upstream does.
    bool refresh();

    // All pairs are looked for again at the next refresh.
    void allChanged();

    const dxMembers &members() const { return m_members; }
    const std::vector<dxOrderedPair> &pairs() const { return m_pairs; }
    static Slot slotOf(const dxGeom *geom);

    // Members have changed: brings `pairs` up to date. Those changed have their new ranks and boxes.
    virtual void update(std::vector<dxOrderedPair> &pairs) = 0;

private:
    void rank(dxGeom *geom, dxRank rank);
    void rankBehindClean(dxGeom *geom, dxRank rank);

    dxMembers m_members;
    std::vector<dxOrderedPair> m_pairs;
    bool m_irregular = false;
};

inline bool dxGeomIsEnabled(const dxGeom *geom) {
    return (geom->gflags & GEOM_ENABLE_TEST_MASK) == GEOM_ENABLE_TEST_VALUE;
}

// The rest of upstream's collideAABBs, for a pair of dxOrderedSpace::pairs().
inline void dxDeliver(const dxOrderedPair &pair, void *data, dNearCallback *callback) {
    if (pair.first->AABBTest(pair.second, pair.second->aabb) == 0) return;
    if (pair.second->AABBTest(pair.first, pair.first->aabb) == 0) return;
    callback(data, pair.first, pair.second);
}
