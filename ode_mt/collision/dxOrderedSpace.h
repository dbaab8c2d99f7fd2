// A collision space that finds its pairs incrementally and calls back in the order of upstream's space of
// the same kind, which tests all pairs anew at each call.
//
// Between two calls of dSpaceCollide it keeps the list of pairs whose boxes overlap, in order. A call costs
// what has changed since the last one, plus one callback per pair.
//
// Invariants, after makeReady():
//  - every geom of the space is a member with a rank, which tells where upstream comes to it. Only geoms that
//    change move to another place, so old ranks stay comparable and only changed geoms may need new ones;
//  - pairs() holds, in order, exactly the pairs for which upstream's collideAABBs passes its tests of body,
//    bits and boxes and which upstream's space would bring to it. None of these can change while the space
//    is locked, which it is while callbacks run. Whether geoms are enabled can, so that is tested when
//    upstream tests it.
//
// All kinds of spaces are of this class. How geoms are cleaned and ranked is up to the kind; so is the order of pairs,
// which is that of their ranks unless a kind has another one. The list of geoms (dxSpace::first) is upstream's, with
// upstream's order, locks and messages.
// One thread at a time, as upstream. docs/collision-order.md.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "collision/dxContactsAhead.h"
#include "collision/dxDensePairs.h"
#include "collision/dxKeptPairs.h"
#include "collision/dxMembers.h"
#include "collision/dxOrderedPair.h"
#include "collision/dxPairSearch.h"
#include "collision/dxRegionIndex.h"
#include "threading/dxSharingPace.h"

class dxOrderedSpace : public dxSpace, protected dxPairPlacer {
public:
    using Slot = dxMembers::Slot;

    // The space, if it is of this class, or NULL.
    static dxOrderedSpace *from(dxSpace *space);
    // The space that a geom is in, likewise.
    static dxOrderedSpace *of(const dxGeom *geom);
    // Of a geom in such a space.
    static Slot slotOf(const dxGeom *geom);

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) override;
    void remove(dxGeom *geom) override;
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // collide() with what can be shared out given to the runner: boxes, the search for pairs, and contacts ahead of
    // the callbacks, which come as ever.
    void collideShared(dxTaskRunner &runner, void *data, dNearCallback *callback);
    // makeReady() with the runner.
    bool makeReadyShared(dxTaskRunner &runner);

    // NULL until contacts were computed ahead for the first time.
    const dxContactsAhead *contactsAhead() const { return m_ahead.get(); }
    dxSharingPace &pace() { return m_pace; }

    // Cleans the geoms and brings pairs() up to date; the space is locked by then. False: upstream's list is
    // not in the state in which ranks stand for it, and has to be walked as upstream does.
    virtual bool makeReady();
    const std::vector<dxOrderedPair> &pairs() const { return m_pairs; }

    // From now on pairs are found by `search`, NULL: by the way that suits the size of the space. Not while
    // the space is locked.
    void setSearch(std::unique_ptr<dxPairSearch> search);
    const dxPairSearch *search() const { return m_search.get(); }

    // The category bits, collide bits or body of a member changed, which moves nothing.
    void filtersChanged(dxGeom *geom);

protected:
    explicit dxOrderedSpace(dSpaceID parent, int type);

    // All pairs are looked for again, from nothing: at this update or at the next.
    void startAnew();
    bool hasSearch() const { return m_search != nullptr; }

    const dxMembers &members() const { return m_members; }
    dxMembers &members() { return m_members; }

    // Cleaning: whether all members have been given their ranks by it; the boxes of geoms ahead of it, on workers if there
    // are any; the box of one geom, and that it is clean; its rank, which may be that which it had, and its bounds, which
    // may be wider than its box.
    virtual bool requireRanks() { return true; }
    void computeBoxes(const std::vector<dxGeom *> &geoms);
    static void clean(const std::vector<dxGeom *> &geoms, std::size_t index);
    void rank(dxGeom *geom, dxRank rank) { this->rank(geom, rank, dxBounds(geom->aabb)); }
    void rank(dxGeom *geom, dxRank rank, const dxBounds &bounds);

    bool isShared() const { return m_runner != nullptr; }
    dxTaskRunner &runner() const { return m_runner != nullptr ? *m_runner : dxTaskRunner::alone(); }
    // To be told of each pair before its callback, or NULL.
    dxContactsAhead *ahead() const { return m_runner != nullptr ? m_ahead.get() : nullptr; }

    // Members have changed, and have their new ranks and boxes: brings `pairs` up to date.
    virtual void update(std::vector<dxOrderedPair> &pairs);
    // By searching and sorting.
    void updateSorted(std::vector<dxOrderedPair> &pairs);
    // The same. `matches` holds what is to be placed as well.
    void findAndPlace(std::vector<dxPairSearch::Match> &matches, std::vector<dxOrderedPair> &pairs);

    // Of two members the one further to the front is the first, and pairs come by it, then by the second.
    bool lead(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool follow(Slot first, Slot second, dxPairKey &key) const override;
    void expect(Slot slot) const override { m_members.expect(slot); }
    // The callbacks of pairs(), where makeReady() says yes. In that order, unless a kind has another one.
    virtual void deliver(void *data, dNearCallback *callback) { deliverInOrder(m_pairs, data, callback); }
    // Of pairs that come by their first geom. Geoms may be enabled and disabled on the way.
    void deliverInOrder(const std::vector<dxOrderedPair> &pairs, void *data, dNearCallback *callback);
    // All of upstream's call, where it says no.
    virtual void walk(void * /*data*/, dNearCallback * /*callback*/) {}
    // The callbacks of a geom, whose box is up to date as the members' are, with those that it meets.
    virtual void collideWith(void *data, dxGeom *geom, dNearCallback *callback) = 0;

    // The members whose boxes overlap the box, front first. Until the next call from the same depth of locks.
    const std::vector<Slot> &findRegion(const dxBounds &box);
    // A geom that is not in the space may move in a callback.
    static bool isStill(const dxGeom *geom, const dxBounds &box);
    // A smaller space is walked as fast.
    bool isWorthAnIndex() const { return count >= 16; }
    // As upstream's collide2 where it walks a list, which is in the order of ranks. NULL, or the member in whose callback
    // the geom moved: upstream goes on behind it with the new box.
    dxGeom *collideRegion(void *data, dxGeom *geom, dNearCallback *callback);

private:
    dxMembers m_members;
    std::vector<dxOrderedPair> m_pairs;
    std::unique_ptr<dxDensePairs> m_dense;             // while the space is small
    std::unique_ptr<dxPairSearch> m_search, m_ownSearch;
    std::vector<dxPairSearch::Match> m_matches;
    std::unique_ptr<dxKeptPairs> m_kept;
    std::unique_ptr<dxRegionIndex> m_index;            // from the first collide2 on
    std::deque<std::vector<Slot>> m_regions;           // by depth of calls of collide2
    dxTaskRunner *m_runner = nullptr;  // of the call in progress, if it is shared
    std::unique_ptr<dxContactsAhead> m_ahead;
    dxSharingPace m_pace;
};

inline bool dxGeomIsEnabled(const dxGeom *geom) {
    return (geom->gflags & GEOM_ENABLE_TEST_MASK) == GEOM_ENABLE_TEST_VALUE;
}

inline dxMeetingFilter dxFilterOf(const dxGeom *geom) { return {geom->body, geom->category_bits, geom->collide_bits}; }

// The rest of upstream's collideAABBs, for a pair of dxOrderedSpace::pairs().
inline void dxDeliver(const dxOrderedPair &pair, void *data, dNearCallback *callback) {
    if (pair.first->AABBTest(pair.second, pair.second->aabb) == 0) return;
    if (pair.second->AABBTest(pair.first, pair.first->aabb) == 0) return;
    callback(data, pair.first, pair.second);
}
