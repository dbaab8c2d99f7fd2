// The three parts in which kinds of spaces differ. A space (dxOrderedSpace) owns one of each and calls them in this order, in each call of
// dSpaceCollide:
//
//   dxSpaceCleaner     boxes and ranks of the geoms that have changed, in upstream's order of cleaning
//   dxSpacePairOrder   the pairs that overlap, in upstream's order of callbacks
//   dxSpaceWalker      the callbacks: of pairs that are known, or of a walk as upstream's where they are not
//
// Parts read and write what the space keeps of its geoms (dxSpaceGeoms) and pairs (dxSpacePairs); none calls the space.
// Threading: as dxOrderedSpace.
#pragma once

#include <vector>

#include <ode/ode.h>

#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxPairRows.h"
#include "collision/pairs/dxKeptPairs.h"
#include "collision/pairs/dxMembers.h"
#include "collision/pairs/dxPair.h"

class dxSpaceCleaner {
public:
    using Slot = dxMembers::Slot;

    // Reserves memory for members in the slots below `slots`, so that cleaning and changes allocate nothing.
    virtual void reserveMemory(Slot slots) = 0;
    // Called when a geom is added or removed, after upstream's checks.
    virtual void onAdded(dxGeom *geom, Slot slot) = 0;
    virtual void onRemoved(Slot slot) = 0;

    // Cleans the geoms in a call of dSpaceCollide, which no call of another thread may overlap. Requires a locked space. Returns whether the ranks
    // represent upstream's order and all boxes that upstream would read are up to date.
    virtual bool cleanToCollide() = 0;
    // Reads the boxes of all members again, as some may have changed without a notification. Returns whether a member is stale
    // (dxMissedNotifications).
    virtual bool readAgain() = 0;

protected:
    ~dxSpaceCleaner() = default;
};

class dxSpacePairOrder : public dxPairKeys {
public:
    // Called if a member has changed, in the outermost call. It may allocate. Returns false if upstream's pairs do not follow from boxes.
    virtual bool prepare() { return true; }
    // Updates kept pairs after members have changed, and notes the work that it took.
    virtual void update(std::vector<dxOrderedPair> &pairs, dxPairWork &work) = 0;
    // Fills the rows in which a call finds all pairs anew, with the geoms that are enabled. Requires the outermost call.
    virtual dxPairRows &gatherRows() = 0;
    // Raises the assertions that upstream's call raises before its first callback. Called after pairs have changed; if it returns true, also in the
    // next call when nothing has changed.
    virtual bool requireValid() const { return false; }

protected:
    ~dxSpacePairOrder() = default;
};

class dxSpaceWalker {
public:
    // Calls the callbacks of the kept pairs, in order.
    virtual void deliver(void *data, dNearCallback *callback) = 0;
    // Finds all pairs anew, row by row, and calls their callbacks.
    virtual void deliverAnew(void *data, dNearCallback *callback) = 0;
    // Executes upstream's whole call, or, with `after`, the rest of it: after a pair in whose callback an assertion failed, or a geom was enabled
    // that is in no pair.
    virtual void walk(void *data, dNearCallback *callback, const dxOrderedPair *after) = 0;
    // Calls the callbacks of a geom with the members that it overlaps. Requires up-to-date boxes.
    virtual void collideWith(void *data, dxGeom *geom, dNearCallback *callback) = 0;

protected:
    ~dxSpaceWalker() = default;
};
