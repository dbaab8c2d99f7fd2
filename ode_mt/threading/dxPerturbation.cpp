#include "threading/dxPerturbation.h"

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/dxEnvironment.h"
#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "core/dxMixedBits.h"

namespace {

std::atomic<std::uint64_t> seed{0};
std::atomic<std::uint64_t> drawn{0};
std::atomic<std::uint64_t> timesReached[kSchedulePoints];

// One point in eight sleeps at first and two yield, later fewer and fewer: a long run, which comes to millions of points, would do
// nothing else. After n points there have been about 1000 (1 + ln(n / 8000)) sleeps.
constexpr std::uint64_t kLeastPeriod = 8, kSleeps = 1000;

// SplitMix64: its state only counts up, so threads can share it.
std::uint64_t randomAt(std::uint64_t place) {
    return dxMixedBits(seed.load(std::memory_order_relaxed) + place * kMixedBitsStep);
}

void sleepUpTo50us(std::uint64_t random) {
    const dxNoCancellation whole;
    const timespec pause{0, static_cast<long>(random % 50000)};
    nanosleep(&pause, nullptr);
}

void disturbAtRandom() {
    const std::uint64_t place = drawn.fetch_add(1, std::memory_order_relaxed);
    const std::uint64_t random = randomAt(place);
    const std::uint64_t kind = random % std::max(kLeastPeriod, place / kSleeps);
    if (kind == 0) {
        sleepUpTo50us(random >> 32);
    } else if (kind <= 2) {
        sched_yield();
    }
}

void startFrom(std::uint64_t newSeed) {
    seed.store(newSeed);
    drawn.store(0);
}

dxDisturbance fromEnvironment() {
    constexpr long long kMaxSeed = std::numeric_limits<long long>::max();
    const char *text = dxEnvironment(dxVariable::Perturb);
    if (text == nullptr) return nullptr;
    long long number = 0;
    switch (dxReadNumber(text, 0, kMaxSeed, number)) {
        case dxNumberText::NoNumber:
            dxLog(dxLogLevel::warning, "ODE_MT_PERTURB is '%.100s'; it takes a number, the seed", text);
            return nullptr;
        case dxNumberText::OutOfRange:
            dxLog(dxLogLevel::warning,
                  "ODE_MT_PERTURB is '%.100s'; known: a number from 0 to %lld; %lld is taken", text,
                  kMaxSeed, number);
            break;
        case dxNumberText::InRange:
            break;
    }
    startFrom(static_cast<std::uint64_t>(number));
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
    startFrom(seed);
    dxSetDisturbance(disturbAtRandom);
}
