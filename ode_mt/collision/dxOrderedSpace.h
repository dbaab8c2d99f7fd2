// A collision space that finds its pairs incrementally and calls back in the order of upstream's space of
// the same kind, which tests all pairs anew at each call.
//
// Between two calls of dSpaceCollide it keeps who is near whom (dxNeighbours) and the sorted list of pairs
// whose boxes overlap. A call costs what has changed since the last one, plus one callback per pair.
//
// Invariants, after refresh():
//  - every geom of the space is a member; of two members, the one nearer to the front of upstream's list has
//    the higher rank. Upstream moves a geom to the front when it changes, and only then, so old ranks stay
//    comparable and only changed geoms need new ones;
//  - m_pairs holds, sorted by key, exactly the pairs for which upstream's collideAABBs passes its tests of
//    body, bits and boxes and which upstream's space would bring to it. None of these can change while the
//    space is locked, which it is while callbacks run. Whether geoms are enabled can, so that is tested
//    when upstream tests it.
//
// The list itself (dxSpace::first) is upstream's, with upstream's order, locks and messages.
// One thread at a time, as upstream. docs/collision-order.md.
#pragma once

#include <cstdint>
#include <vector>

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "collision/dxBounds.h"
#include "collision/dxNeighbours.h"
#include "collision/dxPairKey.h"

struct dxOrderedPair {
    dxPairKey key;
    dxGeom *first, *second;  // in the order of the callback's arguments
    dxNeighbours::Slot slots[2];

    friend bool operator<(const dxOrderedPair &a, const dxOrderedPair &b) { return a.key < b.key; }
};

class dxOrderedSpace : public dxSpace {
public:
    using Slot = dxNeighbours::Slot;

    // The tracking space that a geom is in, or NULL.
    static dxOrderedSpace *of(const dxGeom *geom);

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) override;
    void remove(dxGeom *geom) override;
    void cleanGeoms() override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // The category bits, collide bits or body of a member changed, which moves nothing.
    void filtersChanged(dxGeom *geom);

protected:
    explicit dxOrderedSpace(dSpaceID parent, int type);

    // Brings the members and m_pairs up to date. False: upstream's list is not in the state in which ranks
    // stand for it, and the caller has to walk the list as upstream does.
    bool refresh();

    // All pairs again at the next refresh.
    void allChanged();

    const std::vector<dxOrderedPair> &pairs() const { return m_pairs; }
    dxRank rankOf(Slot slot) const { return m_members[slot].rank; }
    static Slot slotOf(const dxGeom *geom);

    // What the kind of space has to say of a member whose box is new, and of its end.
    virtual void boxChanged(Slot slot, dxGeom *geom) = 0;
    virtual void memberGone(Slot slot) = 0;
    // The key of a pair whose boxes overlap, and in `swapped` whether b comes first in the callback. False:
    // upstream does not bring this pair.
    virtual bool place(Slot a, Slot b, dxPairKey &key, bool &swapped) const = 0;

private:
    struct Member {
        dxGeom *geom = nullptr;  // NULL: free, or gone and not yet out of m_pairs
        dxRank rank = 0;         // 0: not seen by cleanGeoms yet
        dxBounds bounds;
        bool placed = false;     // in m_neighbours, perhaps in m_pairs
    };

    static void setSlot(dxGeom *geom, Slot slot);
    void markChanged(Slot slot);
    void rankFront(dxGeom *geom, dxRank rank);
    void rankRest(dxGeom *geom, dxRank rank);
    void updateMembers();
    void findPairs(Slot slot);
    void mergePairs();
    void forgetChanges();

    std::vector<Member> m_members;  // by slot
    std::vector<Slot> m_free;
    std::vector<Slot> m_gone;       // free after the next refresh
    std::vector<Slot> m_changed;
    std::vector<std::uint8_t> m_isChanged;  // by slot: is in m_changed
    dxRank m_lastRank = 0;
    int m_unranked = 0;
    bool m_irregular = false;
    dxNeighbours m_neighbours;
    std::vector<dxOrderedPair> m_pairs, m_found, m_merged;
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
