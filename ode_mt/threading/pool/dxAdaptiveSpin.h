// Adaptive spinning: a worker spins for the next run about as long as the recent gaps between runs.
//
// Between the parallel stages of two frames lie the serial ones, which often take some hundred microseconds. A worker
// that sleeps through them has to be woken in every frame, which takes longer than many islands do. So a worker
// remembers the longest of its recent waits and spins a little longer than that. Waits beyond kMaxSpin are not worth
// spinning through: they are not remembered, and after the last frame a worker spins for kMaxSpin at most. Without
// short waits the estimate decays to dxSpinTime.
//
// Source of the idea: Karlin, Li, Manasse and Owicki, "Empirical studies of competitive spinning for a shared-memory multiprocessor",
// 1991. Threading: owned by one worker.
#pragma once

#include <algorithm>
#include <chrono>

#include "threading/pool/dxSpin.h"

class dxAdaptiveSpin {
public:
    using Clock = std::chrono::steady_clock;
    using Time = std::chrono::nanoseconds;

    static constexpr Time kMaxSpin = std::chrono::milliseconds(1);

    void beginWait() { m_start = Clock::now(); }
    void endWait() { remember(Clock::now() - m_start); }

    void remember(Time wait) {
        m_longestWait -= m_longestWait / kDecay;
        if (wait <= kMaxSpin) m_longestWait = std::max(m_longestWait, wait);
    }

    Time spinTime() const { return std::clamp<Time>(m_longestWait + m_longestWait / 4, dxSpinTime, kMaxSpin); }

private:
    static constexpr int kDecay = 16;  // share of the memory that each wait takes away

    Clock::time_point m_start{};
    Time m_longestWait{0};
};
