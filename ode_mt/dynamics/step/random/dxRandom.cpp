#include "dynamics/step/random/dxRandom.h"

#include <atomic>

#include "threading/dxSchedulePoints.h"

namespace dxRandom {

namespace {
std::atomic<std::uint32_t> g_seed{0};  // process-wide, because dRand is
}

std::uint32_t sharedSeed() { return g_seed.load(std::memory_order_relaxed); }

void setSharedSeed(std::uint32_t seed) { g_seed.store(seed, std::memory_order_relaxed); }

std::uint32_t drawShared() {
    std::uint32_t seed = sharedSeed();
    while (!g_seed.compare_exchange_weak(seed, next(seed), std::memory_order_relaxed)) {
    }
    return next(seed);
}

std::uint32_t takeSharedBlock(std::uint64_t draws) {
    std::uint32_t seed = sharedSeed();
    dxPerturb(dxSchedulePoint::ReserveDraws);
    while (!g_seed.compare_exchange_weak(seed, jump(seed, draws), std::memory_order_relaxed)) {
    }
    return seed;
}

bool rewindShared(std::uint32_t expected, std::uint32_t seed) {
    return g_seed.compare_exchange_strong(expected, seed, std::memory_order_relaxed);
}

}  // namespace dxRandom
