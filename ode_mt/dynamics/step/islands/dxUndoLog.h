// Saves the state that stepping an island overwrites, so that the step can be undone.
//
// Needed only where the user has installed an error, debug or message handler: if an island then reports something, the
// islands after it must not have been stepped when the handler runs, also if it never returns (longjmp, exception). One
// log per worker; an island is one range of it.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/step/islands/dxIsland.h"

class dxUndoLog {
public:
    using Mark = std::size_t;

    Mark mark() const { return m_bytes.size(); }
    void clear() { m_bytes.clear(); }

    // Appends the state that a step writes: motion and accumulators of the bodies,
    // feedback, and the joints, which keep angles and limit states that the user or the next step reads. Of contacts,
    // which keep nothing, only coefficients that the step corrects.
    void save(const dxIsland &island);

    // Puts everything back that was saved from `begin` up to `end`.
    void restore(Mark begin, Mark end) const;

private:
    void saveJoint(dxJoint &joint);
    void saveBytes(void *address, std::size_t size);

    std::vector<std::byte> m_bytes;  // entries: address, size, bytes
};
