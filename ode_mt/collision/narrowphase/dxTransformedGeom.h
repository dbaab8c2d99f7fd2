// Geoms that a height field has transformed into its frame and not restored.
//
// To collide a geom with a height field upstream transforms it into the field's frame, computes its box there, and
// restores pose and box at the end. A height function that throws or jumps, or an assertion in between, leaves it
// transformed, without a notification of its space. After a jump no code of ours runs; so each thread counts the
// collisions that it has begun and not ended, and the next use of a space reports those that are left
// (dxMissedNotifications). A collision in progress whose height function uses a space has transformed its geom as well,
// and reports once more when it has restored it.
//
// Each thread has a count of its own: the worker reports an exception from its callback.
#pragma once

#include <atomic>

namespace dxTransformedGeom {

extern thread_local unsigned begun;     // neither ended nor reported
extern std::atomic<bool> hasEverBegun;  // on any thread: a program without height fields reads no variable of its thread

void tell();
void end(unsigned collision);

// Calls collide(), which collides a height field with something.
template <class Collide>
int whileTransformed(const Collide &collide) {
    hasEverBegun.store(true, std::memory_order_relaxed);
    const unsigned collision = ++begun;
    try {
        const int count = collide();
        end(collision);
        return count;
    } catch (...) {
        tell();
        throw;
    }
}

// Requires a call before a space reads the boxes of its members.
inline void noticeLeft() {
    if (hasEverBegun.load(std::memory_order_relaxed) && begun != 0) tell();
}

}  // namespace dxTransformedGeom
