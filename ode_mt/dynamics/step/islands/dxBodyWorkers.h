// Which worker has stepped each body in the last step of its world: for replays, which ask for it (dODE_MT_NoteBodyWorkers).
//
// It is kept in the body's tag, which nothing reads between two steps, and which the search for islands resets. A large island that several
// workers step together counts as the caller's.
//
// Threading: of() by the thread that steps the world; note() by the thread that steps the island.
#pragma once

#include <atomic>

#include "dynamics/step/islands/dxIsland.h"

class dxBodyWorkers {
public:
    static constexpr int kNone = -1;

    static void setNoted(bool isNoted) { s_isNoted.store(isNoted, std::memory_order_relaxed); }

    // To be called behind the step of the island. While nobody asks for it it costs one load.
    static void note(const dxIsland &island, unsigned worker) {
        if (__builtin_expect(s_isNoted.load(std::memory_order_relaxed), 0)) tagBodies(island, worker);
    }

    // kNone: the body slept, is new, or workers were not noted.
    static int of(const dxBody &body);

private:
    static void tagBodies(const dxIsland &island, unsigned worker);

    static std::atomic<bool> s_isNoted;
};
