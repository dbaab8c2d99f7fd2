// Where idle workers sleep, and the count of those that are awake and looking for work.
//
// A worker is either at work, searching (awake, will look at the job board before it sleeps) or parked.
// A run that wants n workers relies on the searching ones and wakes only the difference, so that runs
// that follow each other closely need no system call. A woken worker counts as searching from the
// moment somebody decided to wake it; `tokens` holds the decided wake-ups not yet taken up.
//
// No wake-up is lost because both sides write first and read second, sequentially consistent: a run
// publishes its job, then reads the counts; a worker counts itself as parked, then reads the board.
#pragma once

#include "threading/dxSchedulePoints.h"
#include "threading/pool/dxFutex.h"

class dxParking {
public:
    void reset();

    void beginSearch(unsigned workers = 1);
    void endSearch(unsigned workers = 1);
    unsigned searching() const;
    unsigned idle() const;  // searching or parked

    // Parks the calling worker, which was searching, unless stayAwake() holds; it returns searching.
    //
    // One of the parked workers is the monitor: each second it calls monitor(), which may wake workers, itself
    // included. If all are parked there is a monitor, because the last one becomes it if there was none.
    template <typename Condition, typename Watch>
    void park(Condition stayAwake, Watch monitor) {
        countAsParked();
        dxPerturb(dxSchedulePoint::Park);
        if (stayAwake()) {
            unpark();
        } else if (!watched.exchange(true)) {
            while (!tryToTakeToken())
                if (!dxFutexWaitFor(tokens, 0, kMonitorPeriod)) monitor();
            watched.store(false);
        } else {
            takeToken();
        }
    }

    // Makes sure, as far as there are parked workers, that `wanted` workers are searching.
    void wake(unsigned wanted);

    void wakeAll();

private:
    void countAsParked();
    void unpark();
    void takeToken();
    bool tryToTakeToken();

    static constexpr std::chrono::seconds kMonitorPeriod{1};

    std::atomic<std::uint32_t> counts{0};  // searching in the upper 16 bits, parked in the lower
    dxFutexWord tokens{0};
    std::atomic<bool> watched{false};
};
