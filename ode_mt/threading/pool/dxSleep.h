// Sleeping for a moment, while others go on. No cancellation point.
#pragma once

#include <chrono>
#include <thread>

#include "core/dxNoCancellation.h"

inline void dxSleep(std::chrono::microseconds time) {
    const dxNoCancellation whole;
    std::this_thread::sleep_for(time);
}
