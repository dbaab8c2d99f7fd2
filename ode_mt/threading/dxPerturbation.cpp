#include "threading/dxPerturbation.h"

#include <sched.h>
#include <time.h>

#include <cstdint>
#include <limits>

#include "core/dxEnvironment.h"
#include "core/dxLog.h"
#include "core/dxNoCancellation.h"

namespace {

std::atomic<std::uint64_t> randomState{0};
std::atomic<std::uint64_t> timesReached[kSchedulePoints];

// SplitMix64 (Steele, Lea, Flood 2014): the state only counts up, so threads can share it.
std::uint64_t nextRandom() {
    std::uint64_t z = randomState.fetch_add(0x9e3779b97f4a7c15u, std::memory_order_relaxed);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

void disturbAtRandom() {
    const std::uint64_t random = nextRandom();
    switch (random % 8) {
        case 0: {
            const dxNoCancellation whole;
            const timespec pause{0, static_cast<long>((random >> 8) % 50000)};
            nanosleep(&pause, nullptr);
            break;
        }
        case 1:
        case 2:
            sched_yield();
            break;
        default:
            break;
    }
}

dxDisturbance fromEnvironment() {
    constexpr long long kMaxSeed = std::numeric_limits<long long>::max();
    const char *text = dxEnvironment(dxVariable::Perturb);
    if (text == nullptr) return nullptr;
    long long seed = 0;
    switch (dxReadNumber(text, 0, kMaxSeed, seed)) {
        case dxNumberText::NoNumber:
            dxLog(dxLogLevel::warning, "ODE_MT_PERTURB is '%.100s'; it takes a number, the seed", text);
            return nullptr;
        case dxNumberText::OutOfRange:
            dxLog(dxLogLevel::warning,
                  "ODE_MT_PERTURB is '%.100s'; known: a number from 0 to %lld; %lld is taken", text,
                  kMaxSeed, seed);
            break;
        case dxNumberText::InRange:
            break;
    }
    randomState.store(static_cast<std::uint64_t>(seed));
    return disturbAtRandom;
}

}  // namespace

std::atomic<dxDisturbance> dxDisturbanceInForce{fromEnvironment()};

void dxDisturb(dxSchedulePoint point, dxDisturbance disturb) {
    timesReached[static_cast<unsigned>(point)].fetch_add(1, std::memory_order_relaxed);
    disturb();
}

std::uint64_t dxTimesReached(dxSchedulePoint point) {
    return timesReached[static_cast<unsigned>(point)].load(std::memory_order_relaxed);
}

void dxSetDisturbance(dxDisturbance disturb) { dxDisturbanceInForce.store(disturb); }

void dxSetRandomDisturbance(unsigned seed) {
    randomState.store(seed);
    dxSetDisturbance(disturbAtRandom);
}
