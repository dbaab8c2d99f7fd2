#include "dynamics/dxWorkingMemory.h"

#include <cstdlib>

#include "dynamics/dxIdlePool.h"
#include "dynamics/dxIsland.h"

namespace dxWorkingMemory {

namespace {

void *allocate(std::size_t size) { return std::malloc(size); }
void *shrink(void *block, std::size_t, std::size_t size) { return std::realloc(block, size); }
void deallocate(void *block, std::size_t) { std::free(block); }

const dxWorldProcessMemoryManager &manager() {
    static const dxWorldProcessMemoryManager instance(allocate, shrink, deallocate);
    return instance;
}

// Never destroyed: steps may still run while the process ends.
dxIdlePool<dxWorldProcessMemArena> &pool() {
    static auto *const instance = new dxIdlePool<dxWorldProcessMemArena>;
    return *instance;
}

}  // namespace

dxWorldProcessMemArena *take(std::size_t size) {
    constexpr float kReserve = 1.2f;  // so that a slowly growing world does not reallocate at every step
    dxWorldProcessMemArena *arena =
        dxWorldProcessMemArena::ReallocateMemArena(pool().take(), size, &manager(), kReserve, 0);
    if (arena != nullptr) arena->ResetState();
    return arena;
}

void giveBack(dxWorldProcessMemArena *arena) { pool().giveBack(arena); }

void release() { pool().clear(dxWorldProcessMemArena::FreeMemArena); }

}  // namespace dxWorkingMemory
