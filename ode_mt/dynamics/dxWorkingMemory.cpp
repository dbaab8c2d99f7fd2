#include "dynamics/dxWorkingMemory.h"

#include <cstdlib>
#include <mutex>
#include <vector>

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

// Idle arenas, the one used last at the end, where its memory is likely to be in a cache.
struct Pool {
    std::mutex mutex;
    std::vector<dxWorldProcessMemArena *> idle;
};

// Never destroyed: steps may still run while the process ends.
Pool &pool() {
    static Pool *const instance = new Pool;
    return *instance;
}

}  // namespace

dxWorldProcessMemArena *take(std::size_t size) {
    dxWorldProcessMemArena *arena = nullptr;
    {
        std::lock_guard<std::mutex> lock(pool().mutex);
        if (!pool().idle.empty()) {
            arena = pool().idle.back();
            pool().idle.pop_back();
        }
    }
    arena = dxWorldProcessMemArena::ReallocateMemArena(arena, size, &manager(), 1.2f, 0);
    if (arena != nullptr) arena->ResetState();
    return arena;
}

void giveBack(dxWorldProcessMemArena *arena) {
    std::lock_guard<std::mutex> lock(pool().mutex);
    pool().idle.push_back(arena);
}

void release() {
    std::lock_guard<std::mutex> lock(pool().mutex);
    for (dxWorldProcessMemArena *arena : pool().idle) dxWorldProcessMemArena::FreeMemArena(arena);
    pool().idle.clear();
    pool().idle.shrink_to_fit();
}

}  // namespace dxWorkingMemory
