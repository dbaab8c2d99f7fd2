// A short busy wait, for answers that usually come soon: waking a sleeping thread costs 5 to 50 us, on a virtual
// machine 100 us and more; a spinning one answers within 0.1 us.
//
// No thread spins on a machine with one processor, because the awaited thread needs it.
#pragma once

#include <chrono>
#include <thread>

#include "threading/process/dxProcessors.h"

// How long a worker looks for the next run before it sleeps, if it knows nothing of how soon runs follow each
// other (dxAdaptiveSpin).
constexpr std::chrono::microseconds dxSpinTime{50};

// How long a caller waits for the last blocks before it sleeps: about the largest island of a step that pays.
constexpr std::chrono::microseconds dxLastBlocksTime{500};

inline void dxPause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

// Waits until condition() holds, which a running thread is about to make true: spins at first, then lets others run.
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
bool dxSpinUntil(Condition condition, std::chrono::nanoseconds time = dxSpinTime) {
    constexpr int pausesPerClockReading = 8;
    if (condition()) return true;
    if (dxProcessorCount() < 2) return false;
    const auto end = std::chrono::steady_clock::now() + time;
    do {
        for (int i = 0; i < pausesPerClockReading; ++i) {
            dxPause();
            if (condition()) return true;
        }
    } while (std::chrono::steady_clock::now() < end);
    return false;
}
