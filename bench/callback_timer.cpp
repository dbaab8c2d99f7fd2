#include "callback_timer.h"

#include <ode/collision_space.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

// The linker sends this program's calls of dSpaceCollide to __wrap_dSpaceCollide (ld's option --wrap).
extern "C" void __real_dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback);
extern "C" void __wrap_dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback);

namespace {

using Clock = std::chrono::steady_clock;

bool isOn = false;
double clockSeconds = 0;  // that a reading of the clock takes
std::atomic<std::int64_t> nanoseconds{0}, count{0};
thread_local bool isWithin = false;  // a callback that is timed

struct Call {
    void *data;
    dNearCallback *callback;
};

void timed(void *call, dGeomID geom1, dGeomID geom2) {
    const Call &wanted = *static_cast<const Call *>(call);
    const Clock::time_point start = Clock::now();
    isWithin = true;
    wanted.callback(wanted.data, geom1, geom2);
    isWithin = false;
    nanoseconds.fetch_add(std::chrono::nanoseconds(Clock::now() - start).count(), std::memory_order_relaxed);
    count.fetch_add(1, std::memory_order_relaxed);
}

// The least of several means: whatever disturbs a measurement makes it longer.
double measureClock() {
    constexpr int readings = 1000;
    double least = 1;
    for (int i = 0; i < 20; ++i) {
        const Clock::time_point start = Clock::now();
        Clock::time_point end = start;
        for (int k = 0; k < readings; ++k) end = Clock::now();
        least = std::min(least, std::chrono::duration<double>(end - start).count() / readings);
    }
    return least;
}

}  // namespace

namespace bench {

void setCallbackTiming(bool on) {
    isOn = on;
    if (on) clockSeconds = measureClock();
}

CallbackTimes takeCallbackTimes() {
    const double measured = 1e-9 * static_cast<double>(nanoseconds.exchange(0));
    const double timing = clockSeconds * static_cast<double>(count.exchange(0));
    return {std::max(measured - timing, 0.0), 2 * timing};
}

}  // namespace bench

void __wrap_dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback) {
    if (!isOn || isWithin) return __real_dSpaceCollide(space, data, callback);
    Call call = {data, callback};
    __real_dSpaceCollide(space, &call, timed);
}
