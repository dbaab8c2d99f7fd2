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

std::uint64_t withWorldsComingAndGoing() {
    constexpr std::size_t kMaxGrowth =
        256 << 10;  // a hundred bytes a world; a worker that comes late takes its memory late
    comeAndGo(500);
    const std::size_t before = bytesInUse();
    comeAndGo(2500);
    const std::size_t after = bytesInUse();
    if (after > before + kMaxGrowth) {
        std::fprintf(stderr, "%zu bytes in use after 500 worlds, %zu after 3000\n", before, after);
        return 0;
    }
    return playFrames();
}

}  // namespace faults
