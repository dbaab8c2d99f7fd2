#include "fault_world.h"
#include "surroundings.h"

namespace faults {

std::uint64_t playFrames() {
    constexpr int kFrames = 40, kTowers = 24;
    FaultWorld world(SpaceKind::hash, dWorldStep, kTowers);
    for (int i = 0; i < kFrames; ++i) world.frame();
    return world.hash();
}

}  // namespace faults
