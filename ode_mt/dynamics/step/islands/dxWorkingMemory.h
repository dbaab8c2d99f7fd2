// Memory in which a worker steps an island: upstream's arena, one for each worker that takes part.
//
// The caller's own arena is the world's, so that allocators which the user has set are called as
// upstream calls them, on the calling thread. The other workers' arenas come from a pool that all steps
// of the process share, are reused from step to step and grow when a larger island comes; they use
// plain malloc, which may be called from any thread.
#pragma once

#include <cstddef>

class dxWorldProcessMemArena;

namespace dxWorkingMemory {

// An arena of at least `size` bytes, or null if there is no memory. Any thread.
dxWorldProcessMemArena *take(std::size_t size);
void giveBack(dxWorldProcessMemArena *arena);

}  // namespace dxWorkingMemory

// An arena until the end of the scope; null: there is no memory.
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
