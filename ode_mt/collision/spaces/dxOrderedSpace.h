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
//    upstream tests it; those that were disabled when the call began are in no pair, and when one of them is
//    enabled in a callback, the rest of the call goes through the geoms as upstream does.
//
// All kinds of spaces are of this class. How geoms are cleaned and ranked is up to the kind; so is the order
// of pairs, which is that of their ranks unless a kind has another one. The list of geoms (dxSpace::first) is
// upstream's, with upstream's order, locks and messages.
//
// Code of the user's runs while a space is cleaned (bounding-box functions) and while pairs are delivered
// (near-callbacks, box tests), and may collide, clean or ask this space again, or leave for good:
//  - pairs() is brought up to date by the outermost call alone. A call within it that would have to change
//    pairs() goes through the geoms as upstream does (walk);
//  - cleaning that was left half way, or was done by a call within it, is noticed, and all ranks are given
//    anew;
//  - the debug handler may leave by a jump from any assertion of upstream's: what is kept of a member is made
//    before upstream's part of a call begins, and after an assertion all members are looked at again
//    (dxMissedNotifications); the rest of a call that has gone on after one goes through the geoms as
//    upstream does, too;
//  - the destructor leaves the geoms to upstream's, whose calls of the user find no space of this class any
//    more (of).
//
// One thread at a time, as upstream; but while nothing changes, several threads may call collide2. They may
// be the first to look at what has changed before: one does, and the others wait for it, or not for long. (In
// quad-tree and sweep-and-prune spaces geoms must have been cleaned before, as upstream's lists of geoms to
// be cleaned need it.) docs/collision-order.md, docs/kept-state.md.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>
#include <vector>

#include <ode/ode.h>

#include "collision/broadphase/dxBroadPhaseChoice.h"
#include "collision/broadphase/dxCrowd.h"
#include "collision/broadphase/dxDensePairs.h"
#include "collision/broadphase/dxPairSearch.h"
#include "collision/broadphase/dxRegionIndex.h"
#include "collision/narrowphase/dxContactsAhead.h"
#include "collision/pairs/dxKeptPairs.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxMissedNotifications.h"
#include "collision/pairs/dxOrderedPair.h"
#include "collision_kernel.h"
#include "config.h"
#include "objects.h"
#include "threading/dxSharingPolicy.h"

class dxOrderedSpace : public dxSpace, protected dxPairPlacer {
public:
    using Slot = dxMembers::Slot;

    // The space, if it is of this class, or NULL.
    static dxOrderedSpace *from(dxSpace *space);
    // The space that a geom is a member of, or NULL: it is in none, or in one whose destructor has got so
    // far.
    static dxOrderedSpace *of(const dxGeom *geom);
    // Returns the slot of a member.
    static Slot slotOf(const dxGeom *geom);

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) final;
    void remove(dxGeom *geom) final;
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // collide() with what can be shared out given to the runner: boxes, the search for pairs, and contacts
    // ahead of the callbacks, which are called as by collide(). `arraysStay`: as for dxContactsAhead. False:
    // without memory to share it out it was collide() itself.
    bool collideShared(dxTaskRunner &runner, bool arraysStay, void *data, dNearCallback *callback);
    // makeReady() with the runner.
    bool makeReadyShared(dxTaskRunner &runner);

    // NULL until contacts were computed ahead for the first time.
    const dxContactsAhead *contactsAhead() const { return m_ahead.get(); }
    dxSharingPolicy &sharing() { return m_sharing; }

    // Cleans the geoms and brings pairs() up to date; the space is locked by then. False: upstream's list is
    // not in the state in which ranks stand for it, or pairs() is in use; the geoms have to be walked as
    // upstream does.
    virtual bool makeReady();
    // The second half of that: the geoms are clean, and what functions for bounding boxes have done meanwhile
    // is known.
    virtual bool findPairs();
    const std::vector<dxOrderedPair> &pairs() const { return m_pairs; }

    const dxMembers &members() const { return m_members; }

    // Whether a member, or a geom of a space in it, is stray (dxMissedNotifications).
    bool hasStrays();

    // From now on pairs are found by `search`, NULL: by the way that suits the size of the space. Not while
    // the space is locked.
    void setSearch(std::unique_ptr<dxPairSearch> search);
    const dxPairSearch *search() const { return m_search.get(); }
    dxPairSearch *search() { return m_search.get(); }

    // The category bits, collide bits or body of a member changed, which moves nothing.
    void filtersChanged(dxGeom *geom);
    // A member is about to be enabled or disabled.
    virtual void enabledChanges(dxGeom *geom);

protected:
    explicit dxOrderedSpace(dSpaceID parent, int type);

    // All pairs are looked for again, from nothing: at this update or at the next.
    void startAnew();

    // Its box may be another one, though nobody has said so: what is kept of the member is brought up to date.
    virtual void takeBoxAgain(dxGeom *geom) { rank(geom, m_members[slotOf(geom)].rank); }

    // Whether there are strays, or were when this was last asked: their boxes, and whether these are up to
    // date, may change without notice. Costs nothing while no notification has been missed. Of several
    // threads one looks.
    bool mayHaveStrays() { return !isSureOfMembers() && lookForStrays(); }
    // There are none, and nothing may have changed that.
    bool isSureOfMembers() const {
        return m_notificationsMissed.load(std::memory_order_acquire) == dxMissedNotifications::count() &&
               !m_hasStrays.load(std::memory_order_relaxed);
    }
    // Members have become strays in sight of this space; those around it do not see that.
    void noteStrays();
    // Looks at the members themselves.
    virtual bool hasStrayMembers() const = 0;
    // Rays of several threads may ask a space at once; upstream's count then loses some locks.
    void lock() { __atomic_fetch_add(&lock_count, 1, __ATOMIC_RELAXED); }
    void unlock() { __atomic_fetch_sub(&lock_count, 1, __ATOMIC_RELAXED); }
    bool hasSearch() const { return m_search != nullptr; }

    // Takes in members that have been enabled, and leaves out those that have been disabled. False: a call around
    // this one goes through pairs().
    bool takeSwitches();
    // Whether a call in progress may know nothing of a geom that is disabled.
    virtual bool isLeftOut(Slot slot) const { return !m_members.isPresent(slot); }

    dxMembers &members() { return m_members; }

    // Whether upstream takes the geom into a space of this kind.
    virtual bool mayCome(const dxGeom *geom) const;
    // Memory for what is kept of members in the slots below: their cleaning and changes must not need any.
    virtual void makeRoom(Slot slots) = 0;
    // A geom comes, or goes, by a call that upstream will not refuse any more.
    virtual void comes(dxGeom * /*geom*/, Slot /*slot*/) {}
    virtual void goes(dxGeom * /*geom*/, Slot /*slot*/) {}

    // Cleaning: whether all members have been given their ranks by it; the boxes of geoms ahead of it, on
    // workers if there are any; the box of one geom, and that it is clean; its rank, which may be that which
    // it had, and its bounds, which may be wider than its box.
    virtual bool requireRanks() { return true; }
    // cleanGeoms(), in a call that no other thread's may overlap.
    virtual void cleanToCollide() { cleanGeoms(); }
    void computeBoxes(const std::vector<dxGeom *> &geoms);
    static void clean(const std::vector<dxGeom *> &geoms, std::size_t index);
    static void clean(dxGeom *geom);
    void rank(dxGeom *geom, dxRank rank) { this->rank(geom, rank, dxBounds(geom->aabb)); }
    void rank(dxGeom *geom, dxRank rank, const dxBounds &bounds);

    bool isShared() const { return m_runner != nullptr; }
    dxTaskRunner &runner() const { return m_runner != nullptr ? *m_runner : dxTaskRunner::alone(); }
    // What findPairs() needs memory for. Where there is none pairs are found anew at the next call, and this
    // one goes through the geoms as upstream does.
    template <class Find>
    bool whereMemorySuffices(Find find) {
        try {
            return find();
        } catch (const std::bad_alloc &) {
            giveUpPairs();
            return false;
        }
    }
    // What a call of upstream's way needs memory for before its first callback. Where there is none the call
    // ends here, by std::bad_alloc, and may be made again: the space is unlocked.
    template <class Prepare>
    auto beforeCallbacks(Prepare prepare) {
        try {
            return prepare();
        } catch (const std::bad_alloc &) {
            unlock();
            throw;
        }
    }
    // To be told of each pair before its callback, or NULL.
    dxContactsAhead *ahead() const { return m_isAhead ? m_ahead.get() : nullptr; }

    virtual dxPairOrder pairOrder() const = 0;
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
    // All of upstream's call, where it says no; or what of it comes after a pair, in whose callback an
    // assertion failed.
    virtual void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) = 0;
    bool isCrowd() const { return m_crowd.isOne(); }
    // The callbacks of a geom, whose box is up to date as the members' are, with those that it meets.
    virtual void collideWith(void *data, dxGeom *geom, dNearCallback *callback) = 0;

    // The members whose boxes overlap a box, front first; in memory of the caller's.
    class Region {
    public:
        Region(dxOrderedSpace &space, const dxBounds &box) {
            space.m_index.find(space.m_members, box, m_slots);
        }
        Region(const Region &) = delete;
        Region &operator=(const Region &) = delete;

        const std::pmr::vector<Slot> &slots() const { return m_slots; }

    private:
        // A callback may leave by longjmp: what is on the stack needs nobody to free it.
        static constexpr std::size_t kOnStack = 512;

        alignas(std::max_align_t) std::byte m_room[kOnStack * sizeof(Slot)];
        std::pmr::monotonic_buffer_resource m_memory{m_room, sizeof m_room};
        std::pmr::vector<Slot> m_slots{&m_memory};
    };
    // A geom that is not in the space may move in a callback.
    static bool isStill(const dxGeom *geom, const dxBounds &box);
    bool isWorthAnIndex() const { return count >= dxBroadPhaseThresholds::kMinIndexed; }
    // As upstream's collide2 where it walks a list, which is in the order of ranks. NULL, or the member in
    // whose callback the geom moved: upstream goes on behind it with the new box.
    dxGeom *collideRegion(void *data, dxGeom *geom, dNearCallback *callback);

private:
    bool lookForStrays();
    bool updatePairs();
    void giveUpPairs();
    bool prepareAhead(const dxTaskRunner &runner);
    bool isTooMany(std::size_t pairs) const;
    void becomeCrowd();

    dxMembers m_members;
    std::vector<dxOrderedPair> m_pairs;
    std::unique_ptr<dxDensePairs> m_dense;  // while the space is small
    std::unique_ptr<dxPairSearch> m_search, m_ownSearch;
    std::vector<dxPairSearch::Match> m_matches;
    std::unique_ptr<dxKeptPairs> m_kept;
    dxRegionIndex m_index;
    // Of the process, when the members were last looked at.
    std::atomic<std::uint64_t> m_notificationsMissed{0};
    std::atomic<bool> m_hasStrays{false};  // then
    std::mutex m_lookingForStrays;         // only ever tried
    dxCrowd m_crowd;
    std::uint64_t m_comebacks = 0;  // geoms that were left out and have been enabled
    dxTaskRunner *m_runner = nullptr;  // while a shared call makes the space ready: not in its callbacks
    bool m_isAhead = false;            // the call whose callbacks are beginning is a shared one
    dxContactsAhead::Owner m_ahead;
    dxSharingPolicy m_sharing;
};

inline bool dxGeomIsEnabled(const dxGeom *geom) {
    return (geom->gflags & GEOM_ENABLE_TEST_MASK) == GEOM_ENABLE_TEST_VALUE;
}

inline dxMeetingFilter dxFilterOf(const dxGeom *geom) {
    return {geom->body, geom->category_bits, geom->collide_bits};
}

// The rest of upstream's collideAABBs, for a pair of dxOrderedSpace::pairs().
inline void dxDeliver(const dxOrderedPair &pair, void *data, dNearCallback *callback) {
    if (pair.first->AABBTest(pair.second, pair.second->aabb) == 0) return;
    if (pair.second->AABBTest(pair.first, pair.first->aabb) == 0) return;
    callback(data, pair.first, pair.second);
}
