// When a world has been measured enough.
#pragma once

#include "running_average.h"

#include <string>
#include <vector>

namespace bench {

struct StoppingRule {
    double tolerance = 0.02;  // of RunningAverage::relativeSpread
    int minimumRounds = 30;   // so that the quartiles of the paired ratios mean something
    double minimumSeconds = 0;
    double maximumSeconds = 30;
    long maximumFrames = 100'000;

    enum class Verdict { GoOn, Stable, OutOfTime, OutOfFrames };

    // `averages`: one for each engine. `frames`: measured so far by each engine.
    Verdict judge(const std::vector<RunningAverage> &averages, int rounds, double seconds, long frames) const;
};

std::string toString(StoppingRule::Verdict verdict);

}  // namespace bench
