// Upstream's height fields: which geoms are height fields, which of their data objects still exist, and which geoms a collision with one has left
// transformed. For files that look into upstream's geoms.
#pragma once

#include <atomic>

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "heightfield.h"

inline bool dxIsHeightField(const dxGeom &geom) { return geom.type == dHeightfieldClass; }

// Requires a height field. The program may have destroyed the data (dxLiveHeightfields).
inline const dxHeightfieldData *dxHeightsOf(const dxGeom &geom) {
    return static_cast<const dxHeightfield &>(geom).m_p_data;
}

// The existing data objects of height fields.
//
// A program may destroy such data while geoms have it, if it does not collide them any more: upstream then does not
// access it. Code that examines pairs before their callbacks must check here first. Threading: any thread.
namespace dxLiveHeightfields {

// Without memory for the entry, the data counts as destroyed.
void add(const dxHeightfieldData *data);
void remove(const dxHeightfieldData *data);
bool has(const dxHeightfieldData *data);

}  // namespace dxLiveHeightfields

// Geoms that a height field has transformed into its frame and not restored.
//
// To collide a geom with a height field upstream transforms it into the field's frame, computes its box there, and
// restores pose and box at the end. A height function that throws or jumps, or an assertion in between, leaves it
// transformed, without a notification of its space. After a jump no code of ours runs; so each thread counts the
// collisions that it has begun and not ended, and the next use of a space reports those that are left
// (dxMissedNotifications). A collision in progress whose height function uses a space has transformed its geom as well,
// and reports once more when it has restored it.
//
// Threading: each thread has a count of its own; the worker reports an exception from its callback.
namespace dxTransformedGeom {

extern thread_local unsigned begun;     // neither ended nor reported
extern std::atomic<bool> hasEverBegun;  // on any thread: a program without height fields reads no variable of its thread

void report();
void end(unsigned collision);

// Calls collide(), which collides a height field with another geom.
template <class Collide>
int whileTransformed(const Collide &collide) {
    hasEverBegun.store(true, std::memory_order_relaxed);
    const unsigned collision = ++begun;
    try {
        const int count = collide();
        end(collision);
        return count;
    } catch (...) {
        report();
        throw;
    }
}

// Requires a call before a space reads the boxes of its members.
inline void noticeLeft() {
    if (hasEverBegun.load(std::memory_order_relaxed) && begun != 0) report();
}

}  // namespace dxTransformedGeom
