// What a world's frames took between two readings, on average.
#pragma once

#include <vector>

#include "top/frame_board.h"

namespace top {

struct FrameRates {
    WorldFrames world;                 // as it was read last
    unsigned long long frames = 0;     // between the readings
    double perSecond = 0;              // frames
    double frame = 0, collision = 0, step = 0;  // seconds a frame
    double parallelCollisions = 0, parallelSteps = 0;  // parts of all, from 0 to 1
};

// Of worlds that had frames between the readings, or still exist, in the order of processes and worlds. `seconds`: between the readings.
std::vector<FrameRates> ratesBetween(const std::vector<WorldFrames> &before, const std::vector<WorldFrames> &now, double seconds);

// Of all frames of all worlds.
std::vector<FrameRates> ratesOfAll(const std::vector<WorldFrames> &now);

}  // namespace top
