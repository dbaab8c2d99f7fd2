#include "dxPerturbation.h"

#include <sched.h>
#include <time.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>

#include "trace/dxLog.h"

namespace {

std::atomic<std::uint64_t> randomState{0};

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
    const char *text = std::getenv("ODE_MT_PERTURB");
    if (text == nullptr) return nullptr;
    char *end = nullptr;
    errno = 0;
    const unsigned long long seed = std::strtoull(text, &end, 10);
    if (end == text || *end != '\0' || *text == '-' || errno != 0) {
        dxLog(dxLogLevel::warning, "ODE_MT_PERTURB is '%.100s'; it takes a number, the seed", text);
        return nullptr;
    }
    randomState.store(seed);
    return disturbAtRandom;
}

}  // namespace

std::atomic<dxDisturbance> dxDisturbanceInForce{fromEnvironment()};

void dxSetDisturbance(dxDisturbance disturb) { dxDisturbanceInForce.store(disturb); }

void dxSetRandomDisturbance(unsigned seed) {
    randomState.store(seed);
    dxSetDisturbance(disturbAtRandom);
}
