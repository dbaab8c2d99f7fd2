// Stages of a frame whose times a caller's statistics sum up (settings/dxWorldStatistics.h): which of them an event belongs to stands in the
// event. Ticks of dxTimelineClock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

enum class dxFrameStage : unsigned char {
    BroadPhase,
    NearCallbacks,
    NarrowphasePrefetch,
    IslandSearch,
    IslandPreparation,
    Islands,
    Commit,
    Wait,
    None,  // of events of no stage, or within one
};

// Zero only if it is asked for ({}): a collision that is not recorded does not write it.
struct dxFrameTimes {
    std::array<std::uint64_t, static_cast<std::size_t>(dxFrameStage::None) + 1> ticks;

    std::uint64_t &operator[](dxFrameStage stage) { return ticks[static_cast<std::size_t>(stage)]; }
    std::uint64_t operator[](dxFrameStage stage) const { return ticks[static_cast<std::size_t>(stage)]; }
    dxFrameTimes &operator+=(const dxFrameTimes &other) {
        for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i] += other.ticks[i];
        return *this;
    }
};
