// Memory in which islands are stepped: upstream's arena, one for each worker that takes part.
//
// The caller's arena is the world's, so that allocators that the user has set are called as upstream calls them, on the calling thread. The other
// workers' arenas come from a pool that all steps of the process share. They are reused from step to step, and grow for a larger island. They use
// malloc, which any thread may call.
#pragma once

#include <cstddef>

#include "dynamics/step/islands/dxIsland.h"

namespace dxWorkingMemory {

// Returns an arena of at least `size` bytes, or null if there is no memory. Any thread.
dxWorldProcessMemArena *take(std::size_t size);
void giveBack(dxWorldProcessMemArena *arena);

}  // namespace dxWorkingMemory

// A worker's arena until the end of the scope; null: there is no memory.
class dxArenaLease {
public:
    explicit dxArenaLease(std::size_t size) : m_arena(dxWorkingMemory::take(size)) {}
    ~dxArenaLease() {
        if (m_arena != nullptr) dxWorkingMemory::giveBack(m_arena);
    }
    dxArenaLease(const dxArenaLease &) = delete;
    dxArenaLease &operator=(const dxArenaLease &) = delete;

    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessMemArena *const m_arena;
};

// The world's own arena for the time of a step: memory that a user's manager (dWorldSetStepMemoryManager) gave. Requires the thread that called the
// step.
class dxWorldArena {
public:
    explicit dxWorldArena(dxWorld *world)
        : m_context(world->unsafeGetWorldProcessingContext()), m_arena(m_context->ObtainStepperMemArena()) {}
    ~dxWorldArena() { m_context->ReturnStepperMemArena(m_arena); }
    dxWorldArena(const dxWorldArena &) = delete;
    dxWorldArena &operator=(const dxWorldArena &) = delete;

    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    dxWorldProcessContext *m_context;
    dxWorldProcessMemArena *m_arena;
};
