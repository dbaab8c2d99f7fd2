// A collision space that finds its pairs incrementally and calls back in the order of upstream's space of
// the same kind, which tests all pairs anew at each call.
//
// Between two calls of dSpaceCollide it keeps the list of pairs whose boxes overlap, in order. The cost of a call is
// proportional to the changes since the last one, plus one callback per pair.
//
// Where that costs more than to find all pairs anew, none is kept (dxPairKeeping), and they are found and delivered row by row (dxPairRows).
//
// Invariants, after makeReady() has returned true:
//  - every geom of the space is a member with a rank, which gives its place in upstream's order. Only geoms that change
//    move to another place, so old ranks remain comparable and only changed geoms may need new ones;
//  - pairs() holds, in order, exactly the pairs for which upstream's collideAABBs passes its tests of body, bits and
//    boxes and which upstream's space would bring to it. None of these can change while the space is locked, which it
//    is while callbacks run. Whether geoms are enabled can, so that is tested when upstream tests it; those that were
//    disabled when the call began are in no pair, and when one of them is enabled in a callback, the rest of the call
//    walks the geoms as upstream does.
//
// All kinds of spaces are of this class. Each kind defines how geoms are cleaned and ranked, and the order of pairs,
// which by default is that of their ranks. The list of geoms (dxSpace::first) is upstream's, with upstream's order,
// locks and messages.
//
// Code of the user's runs while a space is cleaned (bounding-box functions) and while pairs are delivered
// (near-callbacks, box tests), and may collide, clean or query this space again, or leave by a jump:
//  - only the outermost call updates pairs(). A nested call that would have to change pairs() walks the geoms as
//    upstream does (walk);
//  - an unfinished or nested cleaning is detected, and all ranks are assigned again;
//  - the debug handler may leave by a jump from any assertion of upstream's: the data of a member is complete before
//    upstream's part of a call begins, and after an assertion all members are examined again (dxMissedNotifications); a
//    call that continues after an assertion walks the geoms as upstream does, too;
//  - the destructor leaves the geoms to upstream's destructor, in whose callbacks of() returns NULL.
//
// One thread at a time, as upstream; but while nothing changes, several threads may call collide2. They may be the
// first to process earlier changes: one thread does, and the others wait for it for a limited time. (In quad-tree and
// sweep-and-prune spaces geoms must have been cleaned before, as upstream's lists of geoms to be cleaned need it.)
// docs/collision-order.md, docs/kept-state.md.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>
#include <vector>

#include <sys/single_threaded.h>

#include <ode/ode.h>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxBruteForcePairs.h"
#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/dxPairKeeping.h"
#include "collision/broadphase/dxPairRows.h"
#include "collision/broadphase/dxRegionIndex.h"
#include "collision/narrowphase/dxNarrowphasePrefetch.h"
#include "collision/pairs/dxKeptPairs.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxMissedNotifications.h"
#include "collision/pairs/dxOrderedPair.h"
#include "collision_kernel.h"
#include "collision_space_internal.h"
#include "config.h"
#include "objects.h"
#include "settings/dxOwnThreads.h"
#include "threading/payoff/dxSharingPolicy.h"
#include "threading/timeline/dxTimeline.h"

class dxOrderedSpace : public dxSpace, protected dxPairKeys {
public:
    using Slot = dxMembers::Slot;

    // Returns the space, if it is of this class, or NULL.
    static dxOrderedSpace *from(dxSpace *space);
    // Returns the space of which a geom is a member, or NULL: it is in none, or in one that is being destroyed.
    static dxOrderedSpace *of(const dxGeom *geom);
    // Returns the slot of a member.
    static Slot slotOf(const dxGeom *geom);

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) final;
    void remove(dxGeom *geom) final;
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // collide() with parallel work on the runner: boxes, broad phase, and narrow-phase prefetch; the callbacks are
    // called as by collide(). `arraysStay` is as in dxNarrowphasePrefetch. Returns false if there was no memory for parallel
    // work and collide() ran instead.
    bool collideShared(dxTaskRunner &runner, bool arraysStay, void *data, dNearCallback *callback);
    // makeReady() with the runner.
    bool makeReadyShared(dxTaskRunner &runner);

    // Returns NULL until the first narrow-phase prefetch.
    const dxNarrowphasePrefetch *narrowphasePrefetch() const { return m_prefetch.get(); }
    dxSharingPolicy &sharing() { return m_sharing; }
    // Returns whether calls get a place on the timeline: for fewer geoms they would take longer to record than to do.
    bool isRecorded() const { return count >= kMinRecorded || dxTimeline::isCounted(); }

    dxOwnThreadNumber &ownThreads() { return m_ownThreads; }
    const dxOwnThreadNumber &ownThreads() const { return m_ownThreads; }

    // Cleans the geoms and updates pairs(). Requires a locked space. Returns false if ranks do not represent upstream's
    // list, or pairs() is in use; the geoms must then be walked as upstream does.
    virtual bool makeReady();
    // The second half of makeReady(). Requires clean geoms, and that the effects of bounding-box functions have been
    // detected. It also returns false if no pairs are kept and there is no runner: then deliverAnew() finds them.
    virtual bool findPairs();
    const std::vector<dxOrderedPair> &pairs() const { return m_pairs; }

    const dxMembers &members() const { return m_members; }

    // Returns whether a member, or a geom of a nested space, is stray (dxMissedNotifications).
    bool hasStrays();

    // Sets the broad phase; NULL: the default for the size of the space. Requires an unlocked space.
    void setBroadphase(std::unique_ptr<dxBroadphase> broadphase);
    const dxBroadphase *broadphase() const { return m_broadphase.get(); }
    dxBroadphase *broadphase() { return m_broadphase.get(); }

    // Requires a call when the category bits, collide bits or body of a member changed.
    void filtersChanged(dxGeom *geom);
    // A member is about to be enabled or disabled.
    virtual void enabledChanges(dxGeom *geom);

protected:
    dxOrderedSpace(dSpaceID parent, int type, dxPairOrder order);

    // Discards all pairs; they are found again at this update or at the next.
    void startAnew();

    // Updates the data of a member whose box may have changed without a notification.
    virtual void takeBoxAgain(dxGeom *geom) { rank(geom, m_members[slotOf(geom)].rank); }

    // Whether the geoms may be walked instead. Workers, and a search that was asked for, need the ranks and all pairs.
    bool mayWalk() const { return !isShared() && !hasBroadphase(); }
    // Whether that pays after so many have moved. `comparisons`: as in dxBroadphaseFacts.
    bool isWorthWalking(bool isWalked, int moved, std::size_t comparisons = 0) const;

    // Whether there are strays, or were when this was last asked: their boxes, and whether these are up to date, may
    // change without notice. Costs nothing while no notification has been missed. Only one of several threads examines
    // the members.
    bool mayHaveStrays() { return !isSureOfMembers() && lookForStrays(); }
    // Returns whether there are certainly none.
    bool isSureOfMembers() const {
        return m_notificationsMissed.load(std::memory_order_acquire) == dxMissedNotifications.count() &&
               !m_hasStrays.load(std::memory_order_relaxed);
    }
    // Records new strays, which the spaces around this one do not detect themselves.
    void noteStrays();
    // Examines the members.
    virtual bool hasStrayMembers() const = 0;
    // The counter is atomic: rays of several threads may query a space at once. In a process of one thread, which the C library knows,
    // that would only cost time.
    void lock() { addToLock(1); }
    void unlock() { addToLock(-1); }
    void addToLock(int by) {
        if (__libc_single_threaded != 0)
            lock_count += by;
        else
            __atomic_fetch_add(&lock_count, by, __ATOMIC_RELAXED);
    }
    bool hasBroadphase() const { return m_broadphase != nullptr; }

    // Applies changes of enabled flags to the members. Returns false if an outer call iterates over pairs().
    bool takeSwitches();
    // Returns whether a call in progress may have no data of a disabled geom.
    virtual bool isLeftOut(Slot slot) const { return !m_members.isPresent(slot); }

    dxMembers &members() { return m_members; }

    // Returns whether upstream accepts the geom in a space of this kind.
    virtual bool mayCome(const dxGeom *geom) const;
    // Reserves memory for members in the slots below `slots`, so that cleaning and changes allocate nothing.
    virtual void reserveMemory(Slot slots) = 0;
    // Called when a geom is added or removed, after upstream's checks.
    virtual void comes(dxGeom * /*geom*/, Slot /*slot*/) {}
    virtual void goes(dxGeom * /*geom*/, Slot /*slot*/) {}

    // Functions for cleaning: requireRanks() returns whether all members have ranks; computeBoxes() computes boxes
    // beforehand, on workers if there are any; clean() computes the box of one geom and marks it clean; rank() sets its
    // rank, possibly the old one, and its bounds, which may be wider than its box.
    virtual bool requireRanks() { return true; }
    // cleanGeoms() in a call that no call of another thread may overlap.
    virtual void cleanToCollide() { cleanGeoms(); }
    // Returns whether nothing but clean() and rank() remains to be done for all of them, so that they may be cleaned in any order.
    bool computeBoxes(const std::vector<dxGeom *> &geoms);
    // clean() and rank() for all, on workers. Requires that computeBoxes() has returned true. Ranks fall from `first`; `slots` has room
    // for one of each.
    void cleanComputed(const std::vector<dxGeom *> &geoms, dxRank first, std::vector<Slot> &slots);
    void clean(const std::vector<dxGeom *> &geoms, std::size_t index);
    void clean(dxGeom *geom);
    void rank(dxGeom *geom, dxRank rank) { this->rank(geom, rank, dxBounds(geom->aabb)); }
    void rank(dxGeom *geom, dxRank rank, const dxBounds &bounds);

    void forgetRunner() { m_lent = m_runner = nullptr; }
    bool isShared() const { return m_lent != nullptr; }
    dxTaskRunner &runner() const { return m_runner != nullptr ? *m_runner : dxTaskRunner::alone(); }
    // Calls find(), which may allocate. Without memory the pairs are discarded, and this call walks the geoms as
    // upstream does.
    template <class Find>
    bool whereMemorySuffices(Find find) {
        try {
            return find();
        } catch (const std::bad_alloc &) {
            giveUpPairs();
            return false;
        }
    }
    // Calls prepare(), which may allocate, before the first callback of a walk. Without memory std::bad_alloc is thrown
    // with the space unlocked, so the call may be repeated.
    template <class Prepare>
    auto beforeCallbacks(Prepare prepare) {
        try {
            return prepare();
        } catch (const std::bad_alloc &) {
            unlock();
            throw;
        }
    }
    // Returns the object that must be notified of each pair before its callback, or NULL.
    dxNarrowphasePrefetch *ahead() const { return m_isPrefetching ? m_prefetch.get() : nullptr; }

    dxPairOrder pairOrder() const { return m_keeping.order(); }
    // Updates `pairs` after members have changed, and tells what it took. Requires their new ranks and boxes.
    virtual void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work);
    // Updates the pairs by the broad phase and a sort.
    void updateSorted(std::vector<dxOrderedPair> &pairs, dxPairWork &work);
    // The same, with the additional pairs in `matches`.
    void findAndPlace(std::vector<dxBroadphase::Match> &matches, std::vector<dxOrderedPair> &pairs);
    // Fills the rows in which a call finds all pairs anew, with the geoms that are enabled. Requires the outermost call.
    virtual dxPairRows &gatherRows() = 0;
    // Returns whether a broad phase finds the pairs of this space.
    virtual bool mayKeep() const { return true; }
    // Finds all pairs anew and calls their callbacks.
    virtual void deliverAnew(void *data, dNearCallback *callback) = 0;
    // Calls deliver(pair) for the pairs of the rows for whose first geom begin(geom) returns true, until it returns false.
    template <class Rows, class Begin, class Deliver>
    void forPairsOf(Rows &rows, Begin begin, Deliver deliver) {
        std::size_t pairs = 0;
        for (std::size_t row = 0, end = rows.rows(); row < end; ++row) {
            dxGeom *const first = rows.geom(rows.first(row));
            if (!begin(first)) continue;
            const std::size_t found = rows.find(row);
            pairs += found;
            for (std::size_t i = 0; i < found; ++i)
                if (!deliver(dxOrderedPair{first, rows.geom(rows.second(i)), {}})) return;
        }
        noteAnew(rows, pairs);
    }
    // The same in the way of deliverInOrder().
    template <class Rows>
    void deliverRows(Rows &rows, void *data, dNearCallback *callback);
    // Appends the pairs of all rows.
    static void collectRows(dxPairRows &rows, std::vector<dxOrderedPair> &pairs);
    // Tells what a call has found that found all pairs anew.
    void noteAnew(const dxPairRows &rows, std::size_t pairs);
    // The same; which geoms have changed is known here.
    void noteAnew(dxPairWork work);
    // How often a geom was enabled that a call in progress may have no data of.
    std::uint64_t comebacks() const { return m_comebacks; }

    // The default order: of two members the one further to the front is the first; pairs are ordered by the first, then
    // by the second.
    bool primaryKey(Slot a, Slot b, std::uint64_t &word, bool &swapped) const override;
    bool secondaryKey(Slot first, Slot second, dxPairKey &key) const override;
    void prefetch(Slot slot) const override { m_members.prefetch(slot); }
    // Calls the callbacks of pairs() after makeReady() has returned true, in that order by default.
    virtual void deliver(void *data, dNearCallback *callback) { deliverInOrder(m_pairs, data, callback); }
    // Calls the callbacks of pairs that are ordered by their first geom. Callbacks may enable and disable geoms.
    void deliverInOrder(const std::vector<dxOrderedPair> &pairs, void *data, dNearCallback *callback);
    // makeReady(), on the timeline.
    bool makeReadyRecorded();
    // deliver(), deliverAnew() or walk(), on the timeline.
    void callBack(bool isReady, void *data, dNearCallback *callback);
    void callBackUnkept(void *data, dNearCallback *callback);
    // Of a space with so few geoms that a place on the timeline would cost more than the call.
    void callBackUnrecorded(void *data, dNearCallback *callback);
    // Executes upstream's whole call after makeReady() has returned false, or the rest of it after a pair in whose
    // callback an assertion failed.
    virtual void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) = 0;
    // Calls the callbacks of a geom with the members that it overlaps. Requires up-to-date boxes.
    virtual void collideWith(void *data, dxGeom *geom, dNearCallback *callback) = 0;

    // The members whose boxes overlap a box, front first, in memory of the caller.
    class Region {
    public:
        Region(dxOrderedSpace &space, const dxBounds &box) {
            m_slots.reserve(kOnStack);
            space.m_index.find(space.m_members, box, m_slots);
            space.noteMet(m_slots.size());
        }
        Region(const Region &) = delete;
        Region &operator=(const Region &) = delete;

        const std::pmr::vector<Slot> &slots() const { return m_slots; }

    private:
        // A callback may leave by longjmp: memory on the stack needs no release.
        static constexpr std::size_t kOnStack = 512;

        alignas(std::max_align_t) std::byte m_buffer[kOnStack * sizeof(Slot)];
        std::pmr::monotonic_buffer_resource m_memory{m_buffer, sizeof m_buffer};
        std::pmr::vector<Slot> m_slots{&m_memory};
    };
    // Returns whether the geom's box is still `box`. A geom that is not in the space may move in a callback.
    static bool isStill(const dxGeom *geom, const dxBounds &box);
    bool isWorthAnIndex() const { return count >= dxBroadphaseThresholds::kMinIndexed && m_index.isSelective(); }
    bool isWorthAnIndexByVectors() const { return count >= dxBroadphaseThresholds::kMinIndexedByVectors && m_index.isHighlySelective(); }
    // Requires a call after each query, with the number of members that the geom has met.
    void noteMet(std::size_t members) {
        if (count >= dxBroadphaseThresholds::kMinIndexed) m_index.noteFound(members, static_cast<std::size_t>(count));
    }
    // collide2() of a space that is clean and is asked by comparing all: collideAll() does that. For a few members the rest would take longer.
    template <class CollideAll>
    void collideClean(dxGeom *geom, dNearCallback *callback, const CollideAll &collideAll) {
        dAASSERT(geom && callback);
        lock();
        geom->recomputeAABB();
        collideAll();
        unlock();
    }
    // Equivalent of upstream's collide2 where it walks a list, which has the order of ranks. Returns NULL, or the
    // member in whose callback the geom moved: upstream continues behind it with the new box.
    dxGeom *collideRegion(void *data, dxGeom *geom, dNearCallback *callback);

private:
    static constexpr int kMinRecorded = 8;  // geoms

    bool lookForStrays();
    bool updatePairs();
    void giveUpPairs();
    bool preparePrefetch(const dxTaskRunner &runner);
    bool isTooMany(std::size_t pairs) const;
    bool findAnew();
    void forgetPairs();

    // What a query of a space at rest reads comes first, beside upstream's count, list and lock: a scene may have a space for each of a
    // thousand robots, and each pair of them is a query.
    std::atomic<std::uint64_t> m_notificationsMissed{0};  // the process's counter when the members were last examined
    std::atomic<bool> m_hasStrays{false};                 // then
    dxMembers m_members;
    std::vector<dxOrderedPair> m_pairs;
    std::unique_ptr<dxBruteForcePairs> m_dense;  // while the space is small
    std::unique_ptr<dxBroadphase> m_broadphase, m_defaultBroadphase;
    std::vector<dxBroadphase::Match> m_matches;
    std::unique_ptr<dxKeptPairs> m_kept;
    dxRegionIndex m_index;
    std::mutex m_lookingForStrays;         // only ever tried
    dxPairKeeping m_keeping;
    std::size_t m_touched = 0;    // number of changes of members since pairs were last found
    std::size_t m_pairsAnew = 0;  // number of pairs that the last call found which found all anew
    unsigned m_updates = 0;       // number of calls that have brought kept pairs up to date
    bool m_arePairsKept = true;   // what finds the pairs knows those of members that have not changed
    bool m_isFoundAnew = false;
    std::uint64_t m_comebacks = 0;  // number of absent geoms that were enabled
    dxTaskRunner *m_lent = nullptr;    // during makeReady() of a parallel call, not in its callbacks
    dxTaskRunner *m_runner = nullptr;  // the same, but not while code of the user's may run, which may leave the call by a jump
    bool m_isPrefetching = false;            // the call whose callbacks begin is a parallel one
    dxNarrowphasePrefetch::Owner m_prefetch;
    dxSharingPolicy m_sharing;
    dxOwnThreadNumber m_ownThreads;
};

inline dxOrderedSpace *dxOrderedSpace::from(dxSpace *space) {
    if (space == nullptr) return nullptr;
    switch (space->type) {
    case dSimpleSpaceClass:
    case dHashSpaceClass:
    case dSweepAndPruneSpaceClass:
    case dQuadTreeSpaceClass:
        return static_cast<dxOrderedSpace *>(space);
    default:
        return nullptr;
    }
}

inline bool dxGeomIsEnabled(const dxGeom *geom) {
    return (geom->gflags & GEOM_ENABLE_TEST_MASK) == GEOM_ENABLE_TEST_VALUE;
}

inline dxPairFilter dxFilterOf(const dxGeom *geom) {
    return {geom->body, geom->category_bits, geom->collide_bits};
}

// Whether a user class says that the geom does not meet the other one's box. The classes of upstream's have no such test.
inline bool dxRefusesBoxOf(dxGeom *geom, dxGeom *other) {
    return geom->type >= dFirstUserClass && geom->AABBTest(other, other->aabb) == 0;
}

// The rest of upstream's collideAABBs, for a pair of dxOrderedSpace::pairs().
inline void dxDeliver(const dxOrderedPair &pair, void *data, dNearCallback *callback) {
    if (dxRefusesBoxOf(pair.first, pair.second) || dxRefusesBoxOf(pair.second, pair.first)) return;
    callback(data, pair.first, pair.second);
}

// The same for a pair whose boxes overlap. Returns whether bits and bodies let it pass.
inline bool dxDeliverIfAgreed(dxGeom *first, dxGeom *second, void *data, dNearCallback *callback) {
    if (!dxFiltersAgree(dxFilterOf(first), dxFilterOf(second))) return false;
    dxDeliver({first, second, {}}, data, callback);
    return true;
}

// Upstream's collideAABBs, with its assertions. `overlap` compares the boxes.
template <class Overlap>
inline void dxCollideBoxes(dxGeom *first, dxGeom *second, void *data, dNearCallback *callback, Overlap overlap) {
    if (((first->gflags | second->gflags) & GEOM_AABB_BAD) != 0) return collideAABBs(first, second, data, callback);
    if (first->body == second->body && first->body != nullptr) return;
    if (((first->category_bits & second->collide_bits) | (second->category_bits & first->collide_bits)) == 0) return;
    if (overlap(first->aabb, second->aabb)) dxDeliver({first, second, {}}, data, callback);
}
inline void dxCollideBoxes(dxGeom *first, dxGeom *second, void *data, dNearCallback *callback) {
    dxCollideBoxes(first, second, data, callback, dxOverlap);
}

// A geom against members of a space, one after the other, as upstream's collide2 meets them. Callbacks may move the geom.
class dxGeomQuery {
public:
    dxGeomQuery(void *data, dxGeom *geom, dNearCallback *callback) : m_data(data), m_geom(geom), m_callback(callback) {}

    // Returns how many members it has met.
    std::size_t met() const { return m_met; }
    void meet(dxGeom *member) {
        const bool isReady = (member->gflags & (GEOM_ENABLE_TEST_MASK | GEOM_AABB_BAD)) == GEOM_ENABLE_TEST_VALUE;
        if (isReady && !m_probe.overlaps(member->aabb)) return;
        if (!dxGeomIsEnabled(member)) return;
        ++m_met;
        dxCollideBoxes(member, m_geom, m_data, m_callback);
        m_probe = probeOf(m_geom);
    }

private:
    // While the box is not up to date the next pair's assertion fails, whatever the boxes.
    static dxBoxProbe probeOf(const dxGeom *geom) {
        return (geom->gflags & GEOM_AABB_BAD) == 0 ? dxBoxProbe(geom->aabb) : dxBoxProbe::ofAny();
    }

    void *m_data;
    dxGeom *m_geom;
    dNearCallback *m_callback;
    dxBoxProbe m_probe = probeOf(m_geom);
    std::size_t m_met = 0;
};

template <class Rows>
void dxOrderedSpace::deliverRows(Rows &rows, void *data, dNearCallback *callback) {
    const std::uint64_t missed = dxMissedNotifications.count(), comebacks = m_comebacks;
    forPairsOf(rows, dxGeomIsEnabled, [&](const dxOrderedPair &pair) {
        if (!dxGeomIsEnabled(pair.second)) return true;
        dxDeliver(pair, data, callback);
        if (dxMissedNotifications.count() == missed && m_comebacks == comebacks) return true;
        walk(data, callback, &pair);
        return false;
    });
}
