#include "stopping_rule.h"

#include <algorithm>

namespace bench {

StoppingRule::Verdict StoppingRule::judge(const std::vector<RunningAverage> &averages, int rounds,
                                          double seconds, long frames) const {
    const bool stable = std::all_of(averages.begin(), averages.end(), [this](const RunningAverage &average) {
        return average.relativeSpread() <= tolerance;
    });
    if (stable && rounds >= minimumRounds && seconds >= minimumSeconds) return Verdict::Stable;
    if (frames >= maximumFrames) return Verdict::OutOfFrames;
    if (seconds >= maximumSeconds) return Verdict::OutOfTime;
    return Verdict::GoOn;
}

std::string toString(StoppingRule::Verdict verdict) {
    switch (verdict) {
        case StoppingRule::Verdict::GoOn:
            return "not finished";
        case StoppingRule::Verdict::Stable:
            return "averages stable";
        case StoppingRule::Verdict::OutOfTime:
            return "time limit, averages not yet stable";
        case StoppingRule::Verdict::OutOfFrames:
            return "frame limit, averages not yet stable";
    }
    return "";
}

}  // namespace bench
