// Upstream's table of colliders where classes of the user's are concerned, guarded for several threads of the user.
//
// When two classes meet for the first time, and one is the user's, upstream asks that class for their collider and
// writes it into a plain global table. Two threads that collide such geoms in worlds of their own would race
// for that entry. Here the entry is written under a lock before upstream reads it; the user's functions
// run without the lock, so they may take their time, nest, or leave by longjmp (contract C7).
//
// The table belongs to the process, as upstream's does. With the last dCloseODE upstream forgets the user's classes, and so does this table.
#pragma once

#include <ode/collision.h>

namespace dxColliderTable {

// Requires a call before upstream looks up the collider of two classes, at least if one is the user's.
void resolve(int type1, int type2);

// Do the same as dCreateGeomClass and dSetColliderOverride, errors included.
int createClass(const dGeomClass *description);
void setOverride(int type1, int type2, dColliderFn *collider);

// Requires a call when upstream empties its table (first dInitODE2).
void forget();

}  // namespace dxColliderTable

// The pairs of classes whose collider is the user's (dSetColliderOverride); such colliders run only on the user's thread. The set belongs to the
// process, too.
namespace dxColliderOverrides {

bool has(int type1, int type2);  // in either order

}  // namespace dxColliderOverrides
