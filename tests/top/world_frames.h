// A reading of a world, made by hand.
#pragma once

#include "top/frame_board.h"

inline top::WorldFrames worldFrames(unsigned slot, std::uint32_t process, unsigned number, unsigned long long frames) {
    top::WorldFrames world{slot, process, false, {}};
    world.statistics.size = sizeof world.statistics;
    world.statistics.number = number;
    world.statistics.frames = frames;
    world.statistics.allFrameTime = 0.010 * static_cast<double>(frames - 1);
    world.statistics.allCollisionTime = 0.002 * static_cast<double>(frames);
    world.statistics.allStepTime = 0.005 * static_cast<double>(frames);
    world.statistics.allCollisions = 2 * frames;
    world.statistics.parallelCollisions = frames;
    world.statistics.parallelSteps = frames / 4;
    return world;
}
