// A collision space that finds its pairs incrementally and calls back in the order of upstream's space of the same kind, which tests all pairs at
// each call.
//
// Between two calls of dSpaceCollide it keeps the list of pairs whose boxes overlap, in order. The cost of a call is proportional to the changes
// since the last one, plus one callback per pair.
//
// A call has three stages (collideInStages): geoms are cleaned, pairs are found, callbacks are called. All kinds of spaces derive from this class.
// They differ in three parts, which the derived class owns and this one calls (dxSpaceParts.h): the cleaner, the order of pairs, and the walker. The
// list of geoms (dxSpace::first) is upstream's, with upstream's order, locks and messages.
//
// Invariants, when pairs have been found (dxPairsFound::Kept):
//  - every geom of the space is a member with a rank, which gives its place in upstream's order. Only geoms that change move to another place, so old
//    ranks remain comparable and only changed geoms may need new ones;
//  - pairs() is as dxSpacePairs describes. Callbacks may enable and disable geoms, so a walker tests whether a geom is enabled when upstream tests
//    it. Geoms that were disabled when the call began are in no pair. If a callback enables one of them and upstream would see that, the rest of the
//    call walks the geoms as upstream does.
//
// Code of the user's runs while a space is cleaned (bounding-box functions) and while pairs are delivered (near-callbacks, box tests). It may
// collide, clean or query this space again, or leave by a jump:
//  - only the outermost call updates pairs(). A nested call that would have to change pairs() walks the geoms as upstream does (dxSpaceWalker::walk);
//  - an unfinished or nested cleaning is detected, and all ranks are assigned again;
//  - the debug handler may leave by a jump from any assertion of upstream's. So the data of a member is complete before upstream's part of a call
//    begins, and after an assertion all members are examined again (dxMissedNotifications). A call that continues after an assertion walks the
//    geoms as upstream does, too;
//  - the destructor leaves the geoms to upstream's destructor, in whose callbacks of() returns NULL.
//
// Threading: one thread at a time, as upstream; but while nothing changes, several threads may call collide2. If there are earlier changes to
// process, one of them does, and the others wait for it for a limited time. (In quad-tree and sweep-and-prune spaces geoms must have been cleaned
// before, because upstream's lists of dirty geoms require it.)
// docs/collision.md, docs/exactness.md.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/narrowphase/dxNarrowphasePrefetch.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxSpaceGeoms.h"
#include "collision/spaces/dxSpacePairs.h"
#include "collision/spaces/dxSpaceParts.h"
#include "settings/dxOwnThreads.h"
#include "threading/payoff/dxSharingPolicy.h"
#include "threading/timeline/dxTimeline.h"

class dxOrderedSpace : public dxSpace {
public:
    using Slot = dxMembers::Slot;

    // Returns the space, if it is of this class, or NULL.
    static dxOrderedSpace *from(dxSpace *space);
    // Returns the space of which a geom is a member, or NULL: it is in none, or in one that is being destroyed.
    static dxOrderedSpace *of(const dxGeom *geom) { return geom->tome_ex != nullptr ? from(geom->parent_space) : nullptr; }
    // Returns the slot of a member.
    static Slot slotOf(const dxGeom *geom) { return dxSpaceGeoms::slotOf(geom); }

    ~dxOrderedSpace() override;

    void add(dxGeom *geom) final;
    void remove(dxGeom *geom) final;
    void collide(void *data, dNearCallback *callback) override;
    void collide2(void *data, dxGeom *geom, dNearCallback *callback) override;

    // collide() with parallel work on the runner: boxes, broad phase, and narrow-phase prefetch; the callbacks are
    // called as by collide(). `arraysStay` is as in dxNarrowphasePrefetch. Returns false if there was no memory for parallel
    // work and collide() ran instead.
    bool collideOnWorkers(dxTaskRunner &runner, bool arraysStay, void *data, dNearCallback *callback);
    // The first two stages of a call, with parallel work on the runner. Requires a locked space.
    dxPairsFound findPairsOnWorkers(dxTaskRunner &runner);

    const std::vector<dxOrderedPair> &pairs() const { return m_pairs.all(); }
    const dxMembers &members() const { return m_geoms.members(); }

    // Returns NULL until the first narrow-phase prefetch.
    const dxNarrowphasePrefetch *narrowphasePrefetch() const { return m_prefetch.get(); }
    dxSharingPolicy &sharing() { return m_sharing; }
    // Returns whether calls are recorded on the timeline: for fewer geoms recording would take longer than the call, so only statistics have them.
    bool isRecorded() const { return count >= kMinRecorded || dxTimeline::mayBeCounted(); }

    dxOwnThreadNumber &ownThreads() { return m_ownThreads; }
    const dxOwnThreadNumber &ownThreads() const { return m_ownThreads; }

    // Sets the broad phase; NULL: the default for the size of the space. Requires an unlocked space.
    void setBroadphase(std::unique_ptr<dxBroadphase> broadphase) { m_pairs.setBroadphase(std::move(broadphase)); }
    dxBroadphase *broadphase() { return m_pairs.broadphase(); }
    const dxBroadphase *broadphase() const { return m_pairs.broadphase(); }

    // Requires a call when the category bits, collide bits or body of a member changed.
    void filtersChanged(dxGeom *geom) { m_geoms.filtersChanged(geom); }
    // Requires a call before a member is enabled or disabled.
    void enabledChanges(dxGeom *geom) { m_geoms.enabledChanges(geom); }
    // Returns whether a member, or a geom of a nested space, is stale (dxMissedNotifications).
    bool hasStaleGeoms() { return m_geoms.hasStaleGeoms(); }

    // ---- For its parts ---------------------------------------------------------------------------------------------------------------

    dxSpaceGeoms &geoms() { return m_geoms; }
    dxSpacePairs &foundPairs() { return m_pairs; }
    // Returns the narrow-phase prefetch of this call, which must be notified of each pair before its callback; NULL: there is none.
    dxNarrowphasePrefetch *activePrefetch() const { return m_isPrefetching ? m_prefetch.get() : nullptr; }

protected:
    // The parts may be members of the derived class, as the constructor does not use them. `mayKeep`: as in dxSpacePairs.
    dxOrderedSpace(dSpaceID parent, int type, dxPairOrder kind, dxSpaceCleaner &cleaner, dxSpacePairOrder &order, dxSpaceWalker &walker,
                   bool mayKeep = true);

private:
    static constexpr int kMinRecorded = 8;  // geoms

    void collideInStages(dxTaskRunner *runner, void *data, dNearCallback *callback);
    dxPairsFound findPairs(bool isRecorded);
    dxPairsFound findPairsRecorded();
    void callBack(dxPairsFound found, void *data, dNearCallback *callback);
    void callBackRecorded(dxPairsFound found, void *data, dNearCallback *callback);
    bool preparePrefetch(const dxTaskRunner &runner);

    dxSpaceGeoms m_geoms;  // first, because queries read its first fields beside upstream's
    dxSpaceCleaner &m_cleaner;
    dxSpaceWalker &m_walker;
    dxSpacePairs m_pairs;
    bool m_isPrefetching = false;  // this call has workers, and its pairs are known
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
