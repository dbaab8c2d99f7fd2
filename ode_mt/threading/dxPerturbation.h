// Disturbs the schedule on purpose, so that tests see the orders of events that are rare in practice.
//
// Every thread calls dxPerturb() before it takes a block. It does nothing unless a disturbance is set:
// by the environment variable ODE_MT_PERTURB=seed (pseudo-random yields and sleeps up to 50 us), or by
// a test. Results must not change.
#pragma once

#include <atomic>

using dxDisturbance = void (*)();

extern std::atomic<dxDisturbance> dxDisturbanceInForce;

inline void dxPerturb() {
    const dxDisturbance disturb = dxDisturbanceInForce.load(std::memory_order_relaxed);
    if (__builtin_expect(disturb != nullptr, 0)) disturb();
}

// nullptr: none.
void dxSetDisturbance(dxDisturbance disturb);

// The pseudo-random one, as ODE_MT_PERTURB=seed sets it.
void dxSetRandomDisturbance(unsigned seed);
