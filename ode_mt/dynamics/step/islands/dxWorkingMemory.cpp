#include "dynamics/step/islands/dxWorkingMemory.h"

#include <cstdlib>
#include <new>

#include "threading/process/dxObjectPool.h"
#include "threading/process/dxProcess.h"

namespace dxWorkingMemory {

namespace {

void *allocate(std::size_t size) { return std::malloc(size); }
void *shrink(void *block, std::size_t, std::size_t size) { return std::realloc(block, size); }
void deallocate(void *block, std::size_t) { std::free(block); }

struct HeapManager : dxWorldProcessMemoryManager {
    HeapManager() : dxWorldProcessMemoryManager(allocate, shrink, deallocate) {}
};

struct FreeArena {
    void operator()(dxWorldProcessMemArena *arena) const { dxWorldProcessMemArena::FreeMemArena(arena); }
};

dxProcessObject<HeapManager> manager;
dxProcessObject<dxObjectPool<dxWorldProcessMemArena, FreeArena>> pool;

}  // namespace

dxWorldProcessMemArena *take(std::size_t size) {
    constexpr float kReserve = 1.2f;  // so that a slowly growing world does not reallocate at every step
    dxWorldProcessMemArena *arena = nullptr;
    try {
        arena = pool->take();
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
    arena = dxWorldProcessMemArena::ReallocateMemArena(arena, size, &*manager, kReserve, 0);
    if (arena != nullptr)
        arena->ResetState();
    else
        pool->lose();
    return arena;
}

void giveBack(dxWorldProcessMemArena *arena) { pool->giveBack(arena); }

}  // namespace dxWorkingMemory
