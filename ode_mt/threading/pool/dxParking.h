// Idle workers: how long they spin for the next run, where they sleep, and how many are awake and look for work.
//
// A worker is at work, searching (awake; it will look at the job board before it sleeps) or parked. A run that wants n workers relies on the
// searching ones and wakes only the difference, so that runs that follow each other closely need no system call. A woken worker counts as searching
// from the moment another thread has decided to wake it; m_tokens holds the wake-ups that no worker has taken yet.
//
// No wake-up is lost because both sides write first and read second, sequentially consistent: a run publishes its job, then reads the counts; a
// worker counts itself as parked, then reads the board.
#pragma once

#include <algorithm>
#include <chrono>

#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxFutex.h"
#include "threading/pool/dxSpin.h"

// Adaptive spinning: a worker spins for the next run about as long as the recent gaps between runs.
//
// Between the parallel stages of two frames lie the serial ones, which often take some hundred microseconds. A worker that sleeps meanwhile has to be
// woken in every frame, which takes longer than many islands do. So a worker remembers the longest of its recent waits and spins a little longer than
// that. Waits beyond kMaxSpin are too long to spin: they are not remembered, and after the last frame a worker spins for kMaxSpin at most. Without
// short waits the estimate decays to kSpinTime.
//
// Source of the idea: Karlin, Li, Manasse and Owicki, "Empirical studies of competitive spinning for a shared-memory multiprocessor",
// 1991. Threading: owned by one worker.
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

    Time spinTime() const { return std::clamp<Time>(m_longestWait + m_longestWait / 4, kSpinTime, kMaxSpin); }

private:
    static constexpr int kDecay = 16;  // each wait takes a 16th of the longest away

    Clock::time_point m_start{};
    Time m_longestWait{0};
};

// Where idle workers sleep. Threading: any thread.
class dxParking {
public:
    void reset();

    void beginSearch();
    void endSearch();
    unsigned searching() const;
    unsigned idle() const;  // searching or parked

    // Parks the calling worker, which was searching, unless stayAwake() holds. It returns as a searching one.
    //
    // One of the parked workers is the monitor: each second it calls monitor(), which may wake workers, itself
    // included. If all are parked there is a monitor, because the last one becomes it if there was none.
    template <typename Condition, typename Watch>
    void park(Condition stayAwake, Watch monitor) {
        countAsParked();
        dxPerturb(dxSchedulePoint::Park);
        if (stayAwake()) {
            unpark();
        } else if (!m_isWatched.exchange(true)) {
            while (!tryToTakeToken())
                if (!dxFutexWaitFor(m_tokens, 0, kMonitorPeriod)) monitor();
            m_isWatched.store(false);
        } else {
            takeToken();
        }
    }

    // Wakes workers until `wanted` are searching, as far as any are parked.
    void wake(unsigned wanted);

    void wakeAll();

private:
    void countAsParked();
    void unpark();
    void takeToken();
    bool tryToTakeToken();

    static constexpr std::chrono::seconds kMonitorPeriod{1};

    std::atomic<std::uint32_t> m_counts{0};  // searching in the upper 16 bits, parked in the lower
    dxFutexWord m_tokens{0};
    std::atomic<bool> m_isWatched{false};
};
