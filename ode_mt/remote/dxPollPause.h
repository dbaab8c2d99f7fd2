// How long a thread sleeps between two looks at what it cannot be woken by. The pause grows while nothing comes: a message that is expected is
// seen at once, and a process that waits for minutes takes next to nothing from the others of its machine (docs/remote-islands.md has figures).
//
// Units: ns.
#pragma once

#include <algorithm>
#include <chrono>

class dxPollPause {
public:
    using Duration = std::chrono::nanoseconds;

    // A thread that has waited for so long sleeps so long at most. Pauses are longer than they are asked to be, so that less is counted than has
    // gone by.
    static double longestNs(double waited) { return waited < kLongWaitNs ? kMaxNs : kMaxLongNs; }
    static bool isLong(double waited) { return waited >= kLongWaitNs; }

    void reset() { *this = dxPollPause(); }

    Duration next() {
        const double ns = std::clamp(m_waited / kPart, kMinNs, longestNs(m_waited));
        m_waited += ns;
        return Duration(static_cast<Duration::rep>(ns));
    }

private:
    static constexpr double kPart = 8;  // a pause is an eighth of the time waited so far
    static constexpr double kMinNs = 20e3, kMaxNs = 100e3;
    static constexpr double kLongWaitNs = 1e9, kMaxLongNs = 10e6;

    double m_waited = 0;
};
