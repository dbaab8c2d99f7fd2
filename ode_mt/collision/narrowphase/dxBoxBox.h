// The collider of two boxes, as upstream's dCollideBoxBox and dBoxBox, with vectors (docs/collision.md).
//
// Threading: that of colliders; no state.
#pragma once

#include <ode/collision.h>

#include "collision/narrowphase/boxes/dxBoxContacts.h"

// Does what dBoxBox does, and returns what it returns, or -1 if nothing was done and upstream has to answer.
int dxBoxBox(const dxBoxPair &boxes, dReal *normal, dReal &depth, int &code, int flags, dContactGeom *contacts, int skip);
