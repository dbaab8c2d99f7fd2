// The worker that has stepped each body in the last step of its world, for replays (dODE_MT_NoteBodyWorkers).
//
// The body's tag has it: nothing reads the tag between two steps, and the search for islands resets it. A large island that several
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

    // Called after the step of the island. Costs one load while workers are not noted.
    static void note(const dxIsland &island, unsigned worker) {
        if (__builtin_expect(s_isNoted.load(std::memory_order_relaxed), 0)) tagBodies(island, worker);
    }

    // kNone: the body slept, is new, or workers were not noted.
    static int of(const dxBody &body);

private:
    static void tagBodies(const dxIsland &island, unsigned worker);

    static std::atomic<bool> s_isNoted;
};
