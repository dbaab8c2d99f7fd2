// The geoms of a space: ranks, boxes and filters by slot (dxMembers), the index that answers queries, and whether all of that is up to date.
//
// Cleaners give boxes and ranks through it (clean, rank). A geom may have changed without a notification of its space
// (dxMissedNotifications): then it is stale, and lookForStaleGeoms() finds that out.
//
// Threading: as dxOrderedSpace. Several threads may ask isSure() and mayHaveStaleGeoms() at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include <sys/single_threaded.h>

#include <ode/ode.h>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxRegionIndex.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxUnnoticedChanges.h"
#include "collision/spaces/dxSpaceParts.h"
#include "collision/spaces/dxWalking.h"
#include "threading/dxTaskRunner.h"

#include "collision_kernel.h"
#include "config.h"
#include "objects.h"

inline bool dxGeomIsEnabled(const dxGeom *geom) {
    return (geom->gflags & GEOM_ENABLE_TEST_MASK) == GEOM_ENABLE_TEST_VALUE;
}

inline dxPairFilter dxFilterOf(const dxGeom *geom) {
    return {geom->body, geom->category_bits, geom->collide_bits};
}

class dxSpaceGeoms {
public:
    using Slot = dxMembers::Slot;

    dxSpaceGeoms(dxSpace &space, dxPairOrder order, dxSpaceCleaner &cleaner) : m_space(space), m_cleaner(cleaner), m_order(order) {}
    dxSpaceGeoms(const dxSpaceGeoms &) = delete;
    dxSpaceGeoms &operator=(const dxSpaceGeoms &) = delete;

    // Returns the slot of a member, which is kept in a field that belongs to the space a geom is in.
    static Slot slotOf(const dxGeom *geom) { return static_cast<Slot>(reinterpret_cast<std::uintptr_t>(geom->tome_ex) - 1); }

    dxMembers &members() { return m_members; }
    const dxMembers &members() const { return m_members; }
    dxSpace &space() { return m_space; }
    int count() const { return m_space.count; }
    bool isOutermostCall() const { return m_space.lock_count == 1; }
    dxPairOrder pairOrder() const { return m_order; }

    // Adds or removes a member. Requires that upstream's checks have passed.
    Slot add(dxGeom *geom);
    void remove(dxGeom *geom);
    // Leaves the geoms to upstream's destructor of the space, which follows.
    void release();

    // The lock count is atomic, because rays of several threads may query a space at once; but not in a process of one thread, which the C library
    // tells, as that would only cost time.
    void lock() { addToLock(1); }
    void unlock() { addToLock(-1); }
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

    // ---- Cleaning --------------------------------------------------------------------------------------------------------------------

    // Computes boxes beforehand on workers, if there are any. Returns whether it has computed all boxes: then only clean() and rank() remain, in any
    // order.
    bool computeBoxes(const std::vector<dxGeom *> &geoms);
    // Does clean() and rank() for all geoms, on workers. Requires that computeBoxes() has returned true. Ranks fall from `first`; `slots` is
    // scratch.
    void cleanComputed(const std::vector<dxGeom *> &geoms, dxRank first, std::vector<Slot> &slots);
    // Computes the box of a geom and marks the geom clean. A function of the user's may run. The first form prefetches a later geom of the list.
    void clean(const std::vector<dxGeom *> &geoms, std::size_t index);
    void clean(dxGeom *geom);
    // Sets the rank of a geom, possibly the old one, and its bounds, which may be wider than its box.
    void rank(dxGeom *geom, dxRank rank) { this->rank(geom, rank, dxBounds(geom->aabb)); }
    void rank(dxGeom *geom, dxRank rank, const dxBounds &bounds);
    // Reads the boxes of all members again; their ranks stay.
    void rankAgain() {
        for (dxGeom *geom = m_space.first; geom != nullptr; geom = geom->next) rank(geom, m_members[slotOf(geom)].rank);
    }

    // ---- Walks -----------------------------------------------------------------------------------------------------------------------

    // Tells whether calls walk the geoms as upstream does. Then ranks and presences of members are not kept up to date.
    dxWalking &walking() { return m_walking; }
    const dxWalking &walking() const { return m_walking; }
    // Returns whether the geoms may be walked. Workers, and a broad phase that was set, need the ranks and all pairs.
    bool mayWalk() const { return !hasRunner() && !m_hasBroadphase; }
    void setHasBroadphase(bool hasBroadphase) { m_hasBroadphase = hasBroadphase; }
    // Returns whether a walk pays after `moved` geoms have moved. `comparisons`: as in dxBroadphaseFacts.
    bool isWorthWalking(int moved, std::size_t comparisons = 0) const;

    // ---- Stale geoms -----------------------------------------------------------------------------------------------------------------

    // Returns whether there may be stale geoms; the boxes of these may change without a notification. It costs nothing while no notification has been
    // missed. Otherwise all members are examined, by one of several threads that ask.
    bool mayHaveStaleGeoms() {
        if (isSure()) return false;
        lookForStaleGeoms();
        return true;
    }
    // Returns whether there are certainly none.
    bool isSure() const {
        return m_notificationsMissed.load(std::memory_order_acquire) == dxMissedNotifications.count() &&
               !m_hasStaleGeoms.load(std::memory_order_relaxed);
    }
    // Records new stale geoms, which the spaces around this one do not detect themselves.
    void noteStaleGeoms();
    // Returns whether a member, or a geom of a nested space, is stale.
    bool hasStaleGeoms() {
        mayHaveStaleGeoms();
        return !isSure();
    }

    // ---- Filters and enabled flags ---------------------------------------------------------------------------------------------------

    void filtersChanged(dxGeom *geom);
    // Requires a call before a member is enabled or disabled.
    void enabledChanges(dxGeom *geom);
    // Applies changes of enabled flags to the members. Returns false if an outer call iterates over pairs.
    bool takeSwitches() { return m_members.switched().empty() || applySwitches(); }
    // Returns the number of changes of enabled flags.
    std::uint64_t switches() const { return m_switches; }
    // Returns the number of geoms that were enabled in a callback and of which the call in progress may have no data.
    std::uint64_t reenabled() const { return m_reenabled; }
    // Returns the number of changes of members since the last call.
    std::size_t takeChanges() { return std::exchange(m_changes, 0); }
    void forgetChanges() {
        m_members.forgetChanges();
        m_changes = 0;
    }

    // ---- Workers ---------------------------------------------------------------------------------------------------------------------

    // Sets the runner of a parallel call, until forgetRunner().
    void setRunner(dxTaskRunner &runner) { m_callRunner = m_runner = &runner; }
    void forgetRunner() { m_callRunner = m_runner = nullptr; }
    // Allows the runner again when cleaning has ended.
    void resumeRunner() { m_runner = m_callRunner; }
    bool hasRunner() const { return m_callRunner != nullptr; }
    dxTaskRunner &runner() const { return m_runner != nullptr ? *m_runner : dxTaskRunner::alone(); }

    // ---- Queries ---------------------------------------------------------------------------------------------------------------------

    dxRegionIndex &index() { return m_index; }
    bool isWorthAnIndex() const { return count() >= dxBroadphaseThresholds::kMinIndexed && m_index.isSelective(); }
    bool isWorthAnIndexWithSimd() const { return count() >= dxBroadphaseThresholds::kMinIndexedWithSimd && m_index.isHighlySelective(); }
    // Requires a call after each query, with the number of members that the geom has met.
    void noteMet(std::size_t members) {
        if (count() >= dxBroadphaseThresholds::kMinIndexed) m_index.noteFound(members, static_cast<std::size_t>(count()));
    }

private:
    void lookForStaleGeoms();
    bool applySwitches();
    // Returns whether a call in progress may have no data of the geom in a slot, as it is disabled. A walk reads the current flags.
    bool isLeftOut(Slot slot) const { return m_walking ? !dxGeomIsEnabled(m_members.geomIn(slot)) : !m_members.isPresent(slot); }
    void addToLock(int by) {
        if (__libc_single_threaded != 0)
            m_space.lock_count += by;
        else
            __atomic_fetch_add(&m_space.lock_count, by, __ATOMIC_RELAXED);
    }

    // The fields that a query of a space at rest reads are first, beside upstream's count, list and lock: a scene may have a space for each of a
    // thousand robots, and each pair of these spaces is a query.
    std::atomic<std::uint64_t> m_notificationsMissed{0};  // dxMissedNotifications when the members were last examined
    std::atomic<bool> m_hasStaleGeoms{false};             // result of that examination
    dxMembers m_members;
    dxSpace &m_space;
    dxSpaceCleaner &m_cleaner;
    dxPairOrder m_order;
    bool m_hasBroadphase = false;  // a broad phase was set
    dxRegionIndex m_index;
    dxWalking m_walking;
    std::mutex m_lookingForStaleGeoms;  // only try_lock is used
    std::size_t m_changes = 0;          // number of changes of members since pairs were last found
    std::uint64_t m_switches = 0, m_reenabled = 0;
    dxTaskRunner *m_callRunner = nullptr;  // while a parallel call finds its pairs, not in its callbacks
    dxTaskRunner *m_runner = nullptr;      // the same, but NULL while code of the user's may run, which may leave the call by a jump
};
