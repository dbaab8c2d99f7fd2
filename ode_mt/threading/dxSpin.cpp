#include "dxSpin.h"

#include <algorithm>
#include <atomic>
#include <thread>

unsigned dxProcessorCount() {
    static std::atomic<unsigned> known{0};
    const unsigned count = known.load(std::memory_order_relaxed);
    if (count != 0) return count;
    known.store(std::max(std::thread::hardware_concurrency(), 1u), std::memory_order_relaxed);
    return known.load(std::memory_order_relaxed);
}
