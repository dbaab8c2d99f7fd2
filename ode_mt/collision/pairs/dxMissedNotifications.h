// Counter of events after which a geom may have changed without a notification of its space.
//
// A space keeps data of its members from call to call, and is notified of changes through dxSpace::dirty. Some changes
// cause no notification. Upstream's spaces then continue with the geom at its old place:
//  - dGeomTriMeshSetData marks the box of a mesh as bad, without notifying the space;
//  - an assertion inside dGeomMoved, that the space is locked, comes after the geom was marked and before the space is
//    notified; a debug handler that jumps or throws leaves it so;
//  - a clean geom that is added to a simple or hash space stands in front of those that have changed, at which
//    cleaning stops. The space itself sees that, those around it do not;
//  - a collision with a height field that is left in the middle leaves a geom with another box (dxTransformedGeom).
// A geom marked so is *stray*: dirty, and not among those that its space will clean. From then on dGeomMoved does not
// notify its space, nor the spaces around it. After any such event spaces examine all their members again.
#pragma once

#include "core/dxEventCounter.h"

extern dxEventCounter dxMissedNotifications;
