// ODE's random numbers (ode/misc.h), in place of upstream's misc.cpp. The sequence is dynamics/dxRandom.
#include <ode/misc.h>

#include "dynamics/dxRandom.h"

extern "C" {

unsigned long dRand() { return dxRandom::drawShared(); }

unsigned long dRandGetSeed() { return dxRandom::sharedSeed(); }

void dRandSetSeed(unsigned long seed) { dxRandom::setSharedSeed(static_cast<std::uint32_t>(seed)); }

int dRandInt(int n) { return dxRandom::toRange(dxRandom::drawShared(), static_cast<std::uint32_t>(n)); }

dReal dRandReal() { return static_cast<dReal>(static_cast<double>(dRand()) / 4294967295.0); }

// Self-test of the generator: the first numbers after seed 0.
int dTestRand() {
    constexpr std::uint32_t expected[] = {0x3c6ef35f, 0x47502932, 0xd1ccf6e9, 0xaaf95334, 0x6252e503};
    std::uint32_t seed = 0;
    for (std::uint32_t number : expected) {
        seed = dxRandom::next(seed);
        if (seed != number) return 0;
    }
    return 1;
}

}  // extern "C"
