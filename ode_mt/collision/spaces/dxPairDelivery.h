// The callbacks of pairs: upstream's tests of a pair, and the loops that deliver pairs which a space has found.
//
// Upstream's collideAABBs tests bodies, bits and boxes, then the box tests of user classes, and calls back. Code that has done some of these tests
// before calls dxDeliver or dxDeliverIfAgreed for the rest. Threading: as dxOrderedSpace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <ode/ode.h>

#include "collision/pairs/dxPair.h"
#include "collision/spaces/dxOrderedSpace.h"
#include "core/dxBounds.h"

#include "collision_space_internal.h"

// Returns whether the geom's class is a user's and its box test excludes the other geom. Upstream's classes have no such test.
inline bool dxRefusesBoxOf(dxGeom *geom, dxGeom *other) {
    return geom->type >= dFirstUserClass && geom->AABBTest(other, other->aabb) == 0;
}

// Executes the rest of upstream's collideAABBs for a pair of dxOrderedSpace::pairs().
inline void dxDeliver(const dxOrderedPair &pair, void *data, dNearCallback *callback) {
    if (dxRefusesBoxOf(pair.first, pair.second) || dxRefusesBoxOf(pair.second, pair.first)) return;
    callback(data, pair.first, pair.second);
}

// Does the same for two geoms whose boxes overlap. Returns whether bits and bodies let the pair pass.
inline bool dxDeliverIfAgreed(dxGeom *first, dxGeom *second, void *data, dNearCallback *callback) {
    if (!dxFiltersAgree(dxFilterOf(first), dxFilterOf(second))) return false;
    dxDeliver({first, second, {}}, data, callback);
    return true;
}

// Executes upstream's collideAABBs, with its assertions. `overlap` compares the boxes.
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

// Tells after a callback whether the pairs that were found before it are still upstream's: no notification has been missed, and no geom was enabled
// that is in no pair.
class dxPairsStillHold {
public:
    explicit dxPairsStillHold(const dxSpaceGeoms &geoms) : m_geoms(geoms), m_missed(dxMissedNotifications.count()), m_reenabled(geoms.reenabled()) {}
    explicit operator bool() const { return dxMissedNotifications.count() == m_missed && m_geoms.reenabled() == m_reenabled; }

private:
    const dxSpaceGeoms &m_geoms;
    const std::uint64_t m_missed, m_reenabled;
};

// Calls the callbacks of pairs that are ordered by their first geom. Callbacks may enable and disable geoms.
//
// Upstream tests whether a geom is enabled once before it is paired with those behind it, and each of those at its
// pair. A callback may enable or disable either.
inline void dxDeliverInOrder(dxOrderedSpace &space, dxSpaceWalker &walker, const std::vector<dxOrderedPair> &pairs, void *data,
                             dNearCallback *callback) {
    const dxGeom *front = nullptr;
    bool frontIsEnabled = false;
    dxNarrowphasePrefetch *const prefetch = space.activePrefetch();
    const dxPairsStillHold stillHold(space.geoms());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const dxOrderedPair &pair = pairs[i];
        if (pair.first != front) {
            front = pair.first;
            frontIsEnabled = dxGeomIsEnabled(front);
        }
        if (!frontIsEnabled || !dxGeomIsEnabled(pair.second)) continue;
        if (prefetch != nullptr) prefetch->beforePair(pairs, i);
        dxDeliver(pair, data, callback);
        if (stillHold) continue;
        const dxOrderedPair last = pair;
        return walker.walk(data, callback, &last);
    }
}

// Calls deliver(pair) for the pairs of the rows for whose first geom begin(geom) returns true, until it returns false.
template <class Rows, class Begin, class Deliver>
void dxForPairsOf(Rows &rows, dxSpacePairs &spacePairs, Begin begin, Deliver deliver) {
    std::size_t pairs = 0;
    for (std::size_t row = 0, end = rows.rows(); row < end; ++row) {
        dxGeom *const first = rows.geom(rows.first(row));
        if (!begin(first)) continue;
        const std::size_t found = rows.find(row);
        pairs += found;
        for (std::size_t i = 0; i < found; ++i)
            if (!deliver(dxOrderedPair{first, rows.geom(rows.second(i)), {}})) return;
    }
    spacePairs.noteAnew(rows, pairs);
}

// Does what dxDeliverInOrder() does, for the pairs of rows.
template <class Rows>
void dxDeliverRows(Rows &rows, dxOrderedSpace &space, dxSpaceWalker &walker, void *data, dNearCallback *callback) {
    const dxPairsStillHold stillHold(space.geoms());
    dxForPairsOf(rows, space.foundPairs(), dxGeomIsEnabled, [&](const dxOrderedPair &pair) {
        if (!dxGeomIsEnabled(pair.second)) return true;
        dxDeliver(pair, data, callback);
        if (stillHold) return true;
        walker.walk(data, callback, &pair);
        return false;
    });
}
