// Counters of changes to geoms of which those that keep data about the geoms are not notified.
//
// Both count events of the process. A reader keeps the count beside its data; when the count has changed, the data may be invalid.
// Threading: as dxEventCounter.
#pragma once

#include "core/dxPublished.h"

// Events after which a geom may have changed without a notification of its space.
//
// A space keeps data of its members from call to call, and is notified of changes through dxSpace::dirty. Some changes
// cause no notification. Upstream's spaces then continue with the geom at its old place:
//  - dGeomTriMeshSetData marks the box of a mesh as bad, without notifying the space;
//  - an assertion inside dGeomMoved (the space is locked) fails after the geom was marked and before the space is notified; if the debug handler
//    jumps or throws, the space is never notified;
//  - a clean geom that is added to a simple or hash space is in front of dirty ones, so cleaning stops before these. The space itself notices that,
//    the spaces around it do not;
//  - a collision with a height field that is left in the middle leaves a geom with another box (dxTransformedGeom).
// A geom that was changed so is *stale*: dirty, and not among those that its space will clean. From then on dGeomMoved does not notify its space, nor
// the spaces around it. After any such event spaces examine all their members again.
inline dxEventCounter dxMissedNotifications;

// Changes to inputs of colliders without a notification of the space: samples of a height field, destroyed data of meshes
// or height fields, or the position of a body, which some functions of joints change and restore with rounding.
//
// Prefetched contacts are invalid if the callback, or an earlier one, has made such a change (dxNarrowphasePrefetch).
inline dxEventCounter dxSilentChanges;
