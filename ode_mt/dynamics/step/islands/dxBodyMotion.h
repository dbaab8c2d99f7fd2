// The end of a step for an island's bodies: velocities become positions, and spaces and the user are notified.
//
// Upstream's dxStepBody moves a body, then tells the collision spaces that its geoms moved, which re-links their lists (the order of the next
// frame's pairs), then calls the user, then damps, and goes on with the next body. Here moving and notifying are two operations. On a worker the
// notification is deferred; dxDeferredRun::commit replays it for all bodies, in the order of islands, or worlds, and bodies. Damping and the
// clearing of accumulators read nothing that the spaces write, so the bits stay the same. A body with a callback of the user is never stepped on a
// worker.
//
// In a large island positions come first and the spaces are notified afterwards, in the island's order. The difference is not visible as long as only
// the spaces are notified: see dxMayDeferNotification.
//
// Threading: different islands by different threads, but dxNotifyMoved() by the thread that called the step.
#pragma once

#include <atomic>

#include "dynamics/step/islands/dxIslandStep.h"

// Both steppers call this instead of dxStepBody; so do upstream's, by a seam.
void dxIntegrateIslandBody(dxBody *body, dReal stepSize);

// Returns whether only the spaces are notified when a body moves, at its present velocity: it has no callback, and none of upstream's asserts
// fails. If that holds for all bodies, they may be moved in any order.
bool dxMayDeferNotification(const dxBody &body);

// Notifies the spaces that the island's geoms moved.
void dxNotifyMoved(const dxIsland &island);

// Returns whether a geom of the island is in a space that is being collided: notifying that space is an error, which upstream reports from
// within the step.
bool dxTouchesLockedSpace(const dxIsland &island);

// Decides whether the notifications of all bodies of an island that has workers may be deferred. The stage that sets velocities adds the bodies.
// Spaces that are being collided report an error when they are notified; where the user has a handler for it, nothing may be deferred.
class dxNotificationPolicy {
public:
    explicit dxNotificationPolicy(const dxIslandStep &step);

    // Any thread.
    void add(const dxBody &body);

    bool mayDefer() const { return m_mayDefer.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> m_mayDefer;
};

// Integrates velocities to positions, notifies spaces and callbacks, and clears the accumulators. The island's workers integrate
// where notifications may be deferred.
void dxMoveBodies(const dxIslandStep &step, const dxNotificationPolicy &notifications);
