// How often something may have happened to a geom of which its space was not told.
//
// A space keeps what it knows of its members from call to call, and hears of changes through dxSpace::dirty.
// Some things pass it by, and upstream's spaces too, which go on with the geom where it stands:
//  - dGeomTriMeshSetData marks the box of a mesh as bad, and says nothing to the space;
//  - an assertion inside dGeomMoved, that the space is locked, comes after the geom was marked and before
//    the space is told; a debug handler that jumps or throws leaves it so;
//  - a clean geom that is added to a simple or hash space stands in front of those that have changed, at which
//    cleaning stops. The space itself sees that, those around it do not;
//  - a collision with a height field that is left in the middle leaves a geom with another box (dxTurnedGeom).
// A geom marked so is *stray*: dirty, and not among those that its space will clean. From then on dGeomMoved
// says nothing of it, nor of the spaces around it. After any such event spaces look at all their members
// again.
//
// Any thread.
#pragma once

#include <atomic>
#include <cstdint>

namespace dxMissedNotifications {

extern std::atomic<std::uint64_t> events;

// Rises with each event.
inline std::uint64_t count() { return events.load(std::memory_order_acquire); }
inline void add() { events.fetch_add(1, std::memory_order_acq_rel); }

}  // namespace dxMissedNotifications
