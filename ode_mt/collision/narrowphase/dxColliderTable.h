// Upstream's table of colliders where classes of the user's are concerned, guarded for several threads of the user.
//
// The first time that two classes meet of which one is the user's, upstream asks for their collider and
// writes it into a plain global table. Two threads that collide such geoms in worlds of their own would race
// for that entry. Here the entry is written under a lock before upstream looks at it; the user's functions
// run without the lock, so they may take their time, nest, or leave by longjmp (contract C7).
//
// For the process, as upstream's table is. With the last dCloseODE upstream forgets the user's classes, and so does this table.
#pragma once

#include <ode/collision.h>

namespace dxColliderTable {

// To be called before upstream looks up the collider of two classes, at least if one is the user's.
void resolve(int type1, int type2);

// As dCreateGeomClass and dSetColliderOverride, errors included.
int createClass(const dGeomClass *description);
void setOverride(int type1, int type2, dColliderFn *collider);

// To be called when upstream empties its table (first dInitODE2).
void forget();

}  // namespace dxColliderTable

// The colliders that are the user's (dSetColliderOverride). They run on the user's thread alone. The set is the process's, too.
namespace dxColliderOverrides {

void note(int type1, int type2);  // in both orders
bool has(int type1, int type2);
void forget();

}  // namespace dxColliderOverrides
