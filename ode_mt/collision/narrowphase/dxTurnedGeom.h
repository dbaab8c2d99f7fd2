// Geoms that a height field has turned, and that nobody has turned back.
//
// To collide a geom with a height field upstream moves it into the field's frame, computes its box there, and puts place and
// box back at the end. A function for heights that throws or jumps, or an assertion in between, leaves it turned, and
// nobody tells its space of the other box. After a jump no code of ours runs; so each thread counts the
// collisions that it has begun and not ended, and whoever uses a space next tells of those that are left
// (dxMissedNotifications). One that is still going on, with a function for heights that uses a space, has turned its
// geom, too, and tells once more when it has turned it back.
//
// Each thread has a count of its own: an exception that comes from a worker's callback is told by the worker.
#pragma once

namespace dxTurnedGeom {

extern thread_local unsigned begun;  // and neither ended nor told of

void tell();
void end(unsigned collision);

// Calls collide(), which collides a height field with something.
template <class Collide>
int whileTurned(const Collide &collide) {
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

// Before a space looks at the boxes of its members.
inline void noticeLeft() {
    if (begun != 0) tell();
}

}  // namespace dxTurnedGeom
