// Moving a body and notifying the spaces, as two separate operations.
//
// Upstream's dxStepBody moves a body, then tells the collision spaces that its geoms moved, which re-links their lists
// (the order of the next frame's pairs), then calls the user, then damps. On a worker the notification is deferred;
// dxIslandParallelStep replays it for all bodies in island and body order. Damping and the clearing of accumulators read nothing that
// the spaces write, so the bits stay the same. A body with a callback of the user is never stepped on a worker.
#pragma once

#include "dynamics/step/islands/dxIsland.h"

// Both steppers call this instead of dxStepBody; so do upstream's, by a seam.
void dxIntegrateIslandBody(dxBody *body, dReal stepSize);

// Moves a body and damps it, but tells no space. Any thread; writes the body alone.
void dxIntegrateUntold(dxBody *body, dReal stepSize);

// Whether moving a body, at its present velocity, is heard by nobody but the spaces: it has no callback, and none of upstream's
// asserts fails. Bodies of which all are so may be moved in any order.
bool dxMovesQuietly(const dxBody &body);

// Notifies the spaces that the island's geoms moved.
void dxNotifyMoved(const dxIsland &island);

// Returns whether a geom of the island is in a space that is being collided: notifying that space is an error, which
// upstream reports from within the step.
bool dxTouchesLockedSpace(const dxIsland &island);
