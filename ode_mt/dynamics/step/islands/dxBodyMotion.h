// The end of a step for an island's bodies: velocities become positions, and spaces and the user are told.
//
// Upstream's dxStepBody moves a body, then tells the collision spaces that its geoms moved, which re-links their lists (the order of the next
// frame's pairs), then calls the user, then damps, and goes on with the next body. Here moving and notifying are two operations. On a worker the
// notification is deferred; dxDeferredRun::commit replays it for all bodies, in the order of islands, or worlds, and bodies. Damping and the
// clearing of accumulators read nothing that the spaces write, so the bits stay the same. A body with a callback of the user is never stepped on a
// worker.
//
// In a large island positions come first and the spaces are told afterwards, in the island's order. Nobody sees the difference as long as nobody
// but the spaces hears of any body: see dxMayDeferNotification.
#pragma once

#include <atomic>

#include "dynamics/step/islands/dxIslandStep.h"

// Both steppers call this instead of dxStepBody; so do upstream's, by a seam.
void dxIntegrateIslandBody(dxBody *body, dReal stepSize);

// Moves a body and damps it, but tells no space. Any thread; writes the body alone.
void dxIntegrateUntold(dxBody *body, dReal stepSize);

// Returns whether moving a body, at its present velocity, is heard by nobody but the spaces: it has no callback, and none of upstream's asserts
// fails. Bodies of which all are so may be moved in any order.
bool dxMayDeferNotification(const dxBody &body);

// Notifies the spaces that the island's geoms moved.
void dxNotifyMoved(const dxIsland &island);

// Returns whether a geom of the island is in a space that is being collided: notifying that space is an error, which upstream reports from
// within the step.
bool dxTouchesLockedSpace(const dxIsland &island);

// Whether the notifications of all bodies of an island that has workers may be deferred. Asked body by body by the stage that sets their
// velocities. Spaces that are being collided report an error when they are told; where a handler would hear of it, nothing may be deferred.
class dxNotificationPolicy {
public:
    explicit dxNotificationPolicy(const dxIslandStep &step);

    // Any thread.
    void add(const dxBody &body);

    bool mayDefer() const { return m_mayDefer.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> m_mayDefer;
};

// Integrates velocities to positions, tells spaces and callbacks, and clears the accumulators. Positions are found on the island's
// workers where notifications may be deferred.
void dxMoveBodies(const dxIslandStep &step, const dxNotificationPolicy &notifications);
