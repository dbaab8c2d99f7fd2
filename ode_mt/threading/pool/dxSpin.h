// Busy waiting, for what usually happens soon: waking a sleeping thread costs 5 to 50 us, on a virtual machine 100 us and more. A spinning thread
// answers within 0.1 us.
//
// No thread spins on a machine with one processor, because the awaited thread needs it.
//
// Threading: any thread.
#pragma once

#include <chrono>
#include <thread>

#include "threading/process/dxProcessors.h"

// How long a worker looks for the next run before it sleeps, if it knows nothing of how soon runs follow each
// other (dxAdaptiveSpin).
constexpr std::chrono::microseconds kSpinTime{50};

// How long a caller waits for the last blocks before it sleeps: about the largest island of a step that pays.
constexpr std::chrono::microseconds kLastBlocksTime{500};

inline void dxPause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

// Waits until condition() holds, which a running thread will soon make true: spins at first, then yields.
template <typename Condition>
void dxAwait(const Condition &condition) {
    constexpr int kSpinPolls = 512;
    for (int polls = 0; !condition(); ++polls) {
        if (polls < kSpinPolls)
            dxPause();
        else
            std::this_thread::yield();
    }
}

// Spins until condition() holds or `time` is over; returns whether it holds.
template <typename Condition>
bool dxSpinUntil(Condition condition, std::chrono::nanoseconds time = kSpinTime) {
    constexpr int kPausesPerClockReading = 8;
    if (condition()) return true;
    if (dxProcessorCount() < 2) return false;
    const auto end = std::chrono::steady_clock::now() + time;
    do {
        for (int i = 0; i < kPausesPerClockReading; ++i) {
            dxPause();
            if (condition()) return true;
        }
    } while (std::chrono::steady_clock::now() < end);
    return false;
}
