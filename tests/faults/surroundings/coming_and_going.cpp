#include <malloc.h>

#include <cstdio>

#include "fault_world.h"
#include "surroundings.h"

namespace faults {

namespace {

std::size_t bytesInUse() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

void comeAndGo(int worlds) {
    for (int i = 0; i < worlds; ++i) FaultWorld(static_cast<SpaceKind>(i % 4), dWorldStep, 2).frame();
}

}  // namespace

// What worlds leave behind is more after each round; workers that come late take their memory once.
std::uint64_t withWorldsComingAndGoing() {
    constexpr int kRounds = 4, kWorlds = 2500;
    constexpr std::size_t kMaxGrowth = 256 << 10;  // a hundred bytes a world
    comeAndGo(500);
    std::size_t before = bytesInUse();
    for (int round = 0; round < kRounds; ++round) {
        comeAndGo(kWorlds);
        const std::size_t after = bytesInUse();
        if (after <= before + kMaxGrowth) return playFrames();
        std::fprintf(stderr, "%zu bytes in use, %zu after %d more worlds\n", before, after, kWorlds);
        before = after;
    }
    return 0;
}

}  // namespace faults
