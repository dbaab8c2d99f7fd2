// The end of a step for an island's bodies: velocities become positions.
//
// Upstream moves a body, tells its spaces and its callback, and goes on with the next one. On workers, positions come first and the
// spaces are told afterwards, in the island's order. Nobody sees the difference as long as nobody but the spaces hears of any
// body: see dxMovesQuietly.
#pragma once

#include <atomic>

#include "dynamics/step/islands/dxIslandStep.h"

// Whether all bodies of an island that has workers move quietly. Asked body by body by the stage that sets their velocities. Spaces
// that are being collided report an error when they are told; where a handler would hear of it, nothing is quiet.
class dxQuietMotion {
public:
    explicit dxQuietMotion(const dxIslandStep &step);

    // Any thread.
    void see(const dxBody &body);

    bool isQuiet() const { return m_isQuiet.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> m_isQuiet;
};

// Integrates velocities to positions, tells spaces and callbacks, and clears the accumulators. Positions are found on the island's
// workers where the motion is quiet.
void dxMoveBodies(const dxIslandStep &step, const dxQuietMotion &motion);
