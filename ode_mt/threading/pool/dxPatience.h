// Adaptive spinning: a worker spins for the next run about as long as the recent gaps between runs.
//
// Between the parallel stages of two frames lie the serial ones, which often take some hundred microseconds. A worker
// that sleeps through them has to be woken in every frame, which takes longer than many islands do. So a worker
// remembers the longest of its recent waits and spins a little longer than that. Waits beyond kLongest are not worth
// spinning through: they are not remembered, and after the last frame a worker spins for kLongest at most. Without
// short waits the estimate decays to dxSpinTime.
//
// Threading: owned by one worker.
#pragma once

#include <algorithm>
#include <chrono>

#include "threading/pool/dxSpin.h"

class dxPatience {
public:
    using Clock = std::chrono::steady_clock;
    using Time = std::chrono::nanoseconds;

    static constexpr Time kLongest = std::chrono::milliseconds(1);

    void beginWait() { m_start = Clock::now(); }
    void endWait() { remember(Clock::now() - m_start); }

    void remember(Time wait) {
        m_longest -= m_longest / kFading;
        if (wait <= kLongest) m_longest = std::max(m_longest, wait);
    }

    Time spinTime() const { return std::clamp<Time>(m_longest + m_longest / 4, dxSpinTime, kLongest); }

private:
    static constexpr int kFading = 16;  // share of the memory that each wait takes away

    Clock::time_point m_start{};
    Time m_longest{0};
};
