#include "threading/dxSchedulePoints.h"

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

constexpr const char *kDescriptions[] = {
    "a run takes a slot of the job board",
    "a run is offered to the workers",
    "a worker takes a seat at a run",
    "a thread takes the next block of a run",
    "a thread of an OpenMP team takes the next block",
    "a run without workers goes on to its next block",
    "a thread reports blocks as finished",
    "the caller waits for the blocks of others",
    "a run is taken off the job board",
    "a run decides how many workers to wake",
    "a worker counts itself as parked",
    "a worker that has counted itself as parked finds work after all",
    "a parked worker takes up a wake-up",
    "a block is finished in its turn",
    "a block waits for those before it",
    "a thread takes a part of an island",
    "a thread tells how many rows of its part are done",
    "a part waits for rows of another part",
    "a phase of a job is opened to other threads",
    "a thread takes a chunk of such a phase",
    "the thread that opened it waits for the chunks of others",
    "a thread waits for the next phase",
    "a worker begins an island",
    "an island is interrupted, and later ones are taken back",
    "the islands' steps are made visible",
    "a step reserves its random numbers",
    "a second stepping thread waits for the first one's step",
    "a thread becomes the cleaner of a space",
    "a thread waits for the cleaner of a space",
    "a worker prefetches the contacts of a pair",
    "dCollide answers with prefetched contacts",
    "a worker calls a callback that may run beside others",
    "joints made by such callbacks are put into their lists",
};
static_assert(sizeof kDescriptions / sizeof *kDescriptions == kSchedulePoints, "one sentence for each point");

std::atomic<std::uint64_t> seed{0};
std::atomic<std::uint64_t> drawn{0};
std::atomic<std::uint64_t> timesReached[kSchedulePoints];

// At first one point in eight sleeps and two yield. The part decreases, as a long run with millions of points would otherwise do nothing else: after
// n points there have been about 1000 (1 + ln(n / 8000)) sleeps.
constexpr std::uint64_t kMinPeriod = 8, kSleeps = 1000;

// SplitMix64: its state only counts up, so threads can share it.
std::uint64_t randomAt(std::uint64_t place) {
    return dxMixedBits(seed.load(std::memory_order_relaxed) + place * kMixedBitsStep);
}

void sleepUpTo50us(std::uint64_t random) {
    const dxNoCancellation whole;
    const timespec pause{0, static_cast<long>(random % 50000)};
    nanosleep(&pause, nullptr);
}

void perturbAtRandom() {
    const std::uint64_t place = drawn.fetch_add(1, std::memory_order_relaxed);
    const std::uint64_t random = randomAt(place);
    const std::uint64_t kind = random % std::max(kMinPeriod, place / kSleeps);
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

dxPerturbation fromEnvironment() {
    constexpr long long kMaxSeed = std::numeric_limits<long long>::max();
    const char *text = dxEnvironment(dxVariable::Perturb);
    if (text == nullptr) return nullptr;
    long long number = 0;
    switch (dxReadNumber(text, 0, kMaxSeed, number)) {
        case dxNumberText::NoNumber:
            dxLog(dxLogLevel::Warning, "ODE_MT_PERTURB is '%.100s'; it takes a number, the seed", text);
            return nullptr;
        case dxNumberText::OutOfRange:
            dxLog(dxLogLevel::Warning,
                  "ODE_MT_PERTURB is '%.100s'; known: a number from 0 to %lld; %lld is taken", text,
                  kMaxSeed, number);
            break;
        case dxNumberText::InRange:
            break;
    }
    startFrom(static_cast<std::uint64_t>(number));
    return perturbAtRandom;
}

}  // namespace

const char *dxDescribe(dxSchedulePoint point) { return kDescriptions[static_cast<unsigned>(point)]; }

std::atomic<dxPerturbation> dxPerturbationInForce{fromEnvironment()};

void dxPerturbBy(dxPerturbation perturb, dxSchedulePoint point) {
    timesReached[static_cast<unsigned>(point)].fetch_add(1, std::memory_order_relaxed);
    perturb();
}

std::uint64_t dxTimesReached(dxSchedulePoint point) {
    return timesReached[static_cast<unsigned>(point)].load(std::memory_order_relaxed);
}

void dxSetPerturbation(dxPerturbation perturb) { dxPerturbationInForce.store(perturb); }

void dxSetRandomPerturbation(unsigned seed) {
    startFrom(seed);
    dxSetPerturbation(perturbAtRandom);
}
