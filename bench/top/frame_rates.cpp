#include "top/frame_rates.h"

#include <algorithm>
#include <tuple>

namespace top {

namespace {

double part(double some, double all) { return all > 0 ? some / all : 0; }

// `before`: zeros if the world was not there.
FrameRates rates(const dODE_MT_WorldStatistics &before, const WorldFrames &world) {
    const dODE_MT_WorldStatistics &now = world.statistics;
    FrameRates result;
    result.world = world;
    result.frames = now.frames - before.frames;
    const auto frames = static_cast<double>(result.frames);
    // The first frame has no beginning, and so no time.
    result.frame = part(now.allFrameTime - before.allFrameTime, before.frames == 0 ? frames - 1 : frames);
    result.collision = part(now.allCollisionTime - before.allCollisionTime, frames);
    result.step = part(now.allStepTime - before.allStepTime, frames);
    result.parallelCollisions = part(static_cast<double>(now.parallelCollisions - before.parallelCollisions),
                                     static_cast<double>(now.allCollisions - before.allCollisions));
    result.parallelSteps = part(static_cast<double>(now.parallelSteps - before.parallelSteps), frames);
    return result;
}

const dODE_MT_WorldStatistics &find(const std::vector<WorldFrames> &worlds, const WorldFrames &world) {
    static const dODE_MT_WorldStatistics none{};
    for (const WorldFrames &other : worlds)
        if (other.slot == world.slot && other.process == world.process && other.statistics.number == world.statistics.number)
            return other.statistics;
    return none;
}

void sort(std::vector<FrameRates> &all) {
    std::sort(all.begin(), all.end(), [](const FrameRates &a, const FrameRates &b) {
        return std::tie(a.world.process, a.world.statistics.number) < std::tie(b.world.process, b.world.statistics.number);
    });
}

}  // namespace

std::vector<FrameRates> ratesBetween(const std::vector<WorldFrames> &before, const std::vector<WorldFrames> &now, double seconds) {
    std::vector<FrameRates> result;
    for (const WorldFrames &world : now) {
        FrameRates ofWorld = rates(find(before, world), world);
        ofWorld.perSecond = part(static_cast<double>(ofWorld.frames), seconds);
        if (ofWorld.frames != 0 || !world.hasEnded) result.push_back(ofWorld);
    }
    sort(result);
    return result;
}

std::vector<FrameRates> ratesOfAll(const std::vector<WorldFrames> &now) {
    std::vector<FrameRates> result;
    for (const WorldFrames &world : now) {
        result.push_back(rates({}, world));
        result.back().perSecond = part(1, result.back().frame);
    }
    sort(result);
    return result;
}

}  // namespace top
