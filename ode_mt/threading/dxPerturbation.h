// Perturbs the schedule on purpose, so that tests cover rare orders of events.
//
// Every thread calls dxPerturb() at each dxSchedulePoint. It does nothing unless a disturbance is set:
// by the environment variable ODE_MT_PERTURB=seed (pseudo-random yields and sleeps up to 50 us), or by
// a test. Results must not change.
#pragma once

#include <atomic>
#include <cstdint>

#include "threading/dxSchedulePoint.h"

using dxDisturbance = void (*)();

extern std::atomic<dxDisturbance> dxDisturbanceInForce;

// Counts the point and calls the disturbance.
void dxDisturb(dxSchedulePoint point, dxDisturbance disturb);

inline void dxPerturb(dxSchedulePoint point) {
    const dxDisturbance disturb = dxDisturbanceInForce.load(std::memory_order_relaxed);
    if (__builtin_expect(disturb != nullptr, 0)) dxDisturb(point, disturb);
}

// How many times threads have been at a point while a disturbance was set.
std::uint64_t dxTimesReached(dxSchedulePoint point);

// nullptr: none.
void dxSetDisturbance(dxDisturbance disturb);

// The pseudo-random one, as ODE_MT_PERTURB=seed sets it.
void dxSetRandomDisturbance(unsigned seed);
