// The end of a step for an island's bodies: velocities become positions.
//
// Upstream moves a body, tells its spaces and its callback, and goes on with the next one. On workers, positions come first and the
// spaces are told afterwards, in the island's order. Nobody sees the difference as long as nobody but the spaces hears of any
// body: see dxMovesQuietly.
#pragma once

#include <atomic>

#include "dynamics/step/islands/dxIslandStep.h"

// Whether notifications of an island that has workers may be deferred until all its bodies have moved: only spaces are notified of any of them.
// The stage that sets velocities adds the bodies. Spaces that are being collided report an error when they are notified; where a handler would hear of it,
// notifications are not deferred.
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
