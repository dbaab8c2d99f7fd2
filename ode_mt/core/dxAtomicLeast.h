// The least of what several threads find.
#pragma once

#include <atomic>

// Relaxed: whoever reads it after the threads have been joined sees the least value.
inline void dxLowerTo(std::atomic<unsigned> &least, unsigned value) {
    unsigned known = least.load(std::memory_order_relaxed);
    while (value < known && !least.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
}
