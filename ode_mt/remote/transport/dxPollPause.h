// How long a thread sleeps between two looks at what it cannot be woken by. The pause grows while nothing comes: a message that is expected is
// seen at once, and a process that waits for minutes takes next to nothing from the others of its machine
// (docs/notes/2026-11-remote-experiments.md has figures).
//
// A thread that has nothing else to do looks at once again for a moment, before its first pause: to fall asleep and wake up takes a core longer than
// most answers take to come. It keeps its core for that moment: one that yields it to a thread that computes gets it back at the end of a time slice
// (4 ms, Linux 6.18).
//
// Units: ns.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

#include "threading/process/dxProcessors.h"

class dxPollPause {
public:
    using Duration = std::chrono::nanoseconds;

    // A thread that has waited for so long sleeps so long at most. Pauses are longer than they are asked to be, so that less is counted than has
    // gone by.
    static double longestNs(double waited) { return waited < kLongWaitNs ? kMaxNs : kMaxLongNs; }
    static bool isLong(double waited) { return waited >= kLongWaitNs; }

    // What a thread sleeps that has slept so long.
    static double pauseNs(double waited, double mostNs) { return std::clamp(waited / kPart, kMinNs, mostNs); }

    // For which it looks at once.
    static constexpr std::chrono::microseconds kAtOnce{100};

    void reset() { *this = dxPollPause(); }

    // Returns whether the wait has just begun, and a pause does not pay yet.
    bool isAtOnce(Duration moment = kAtOnce) const { return dxProcessorCount() > 1 && Clock::now() - m_since < moment; }

    void wait() {
        if (!isAtOnce()) std::this_thread::sleep_for(next());
    }

    Duration next() { return next(longestNs(m_waited)); }
    Duration next(double mostNs) {
        const double ns = pauseNs(m_waited, mostNs);
        m_waited += ns;
        return Duration(static_cast<Duration::rep>(ns));
    }

private:
    using Clock = std::chrono::steady_clock;

    static constexpr double kPart = 8;  // a pause is an eighth of the time waited so far
    static constexpr double kMinNs = 20e3, kMaxNs = 100e3;
    static constexpr double kLongWaitNs = 1e9, kMaxLongNs = 10e6;

    Clock::time_point m_since = Clock::now();
    double m_waited = 0;
};
