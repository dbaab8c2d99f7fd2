// The kinds of events of a timeline, each a constant to which records point, and the stages of a frame whose times statistics sum up
// (settings/dxWorldStatistics.h). An event says to which stage it belongs.
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
    Shared,  // the calling thread is in stages that several threads may share: dxWorkersRunner
    Work,    // what all threads do in these, added up
    None,  // events of no stage, or within one
};

// The time of each stage. Units: ticks of dxTimelineClock. Zero only if it is initialised ({}): a collision that is not recorded does not write it.
struct dxFrameTimes {
    std::array<std::uint64_t, static_cast<std::size_t>(dxFrameStage::None) + 1> ticks;

    std::uint64_t &operator[](dxFrameStage stage) { return ticks[static_cast<std::size_t>(stage)]; }
    std::uint64_t operator[](dxFrameStage stage) const { return ticks[static_cast<std::size_t>(stage)]; }
    dxFrameTimes &operator+=(const dxFrameTimes &other) {
        for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i] += other.ticks[i];
        return *this;
    }
};

struct dxTimelineEvent {
    static constexpr unsigned kMaxArguments = 4;

    enum class Kind : unsigned char {
        Span,     // from one time to another, in a frame
        Idle,     // the same, between frames; without arguments
        Counter,  // its arguments are quantities, each with a curve
    };

    const char *name;
    const char *category;                      // by which a viewer filters
    const char *arguments[kMaxArguments] = {};  // names; null: none
    Kind kind = Kind::Span;
    dxFrameStage stage = dxFrameStage::None;  // of spans whose times are summed up
};
