// Chooses the number of grid cells per axis, from 5 to 20, by measured time (thesis 10.2).
//
// Climb: from 5 cells up, one more per interval, until there are as many clusters as entities (sets of
// bodies connected by joints and contacts, found by one collision pass) or 20 cells are reached. This much is the
// thesis's, which aimed at the number of clusters. Here the aim is time: the median frame of each number of cells is
// kept, and the climb ends at the cheapest. A number of cells that costs kTooExpensive times as much as the cheapest is
// left after kTrialFrames frames; two such numbers in a row end the climb, since finer grids cost even more.
//
// Hold: when the cost at the present number n has drifted by more than kDrift since it was chosen, n-1 and
// n+1 are probed for an interval each, and one of them is taken if it is clearly cheaper; then its neighbours are
// probed, and so on. A probe without success doubles the time until the next one. Only reset()
// starts over: one more object is at most a drift.
//
// Bounds on the frames spent away from the best number known, with I the interval:
//   climb    at most 16 (I+1) frames, once; the +1 pays for the new grid and is not counted
//   probing  at most 2 (I+1) frames after each hold of at least 16 I frames, less than one in eight at the
//            default I; without success the hold doubles up to 1024 I, one in 480
// A candidate takes more than kTrialFrames counted frames only while its median is below kTooExpensive times the
// best.
//
// The grid affects speed, never the result, so any answer is right.
//
// Not done, and why: counting clusters alone ends at 20 cells in a world that is faster at 8; means instead
// of medians let one frame decide during which the system took the thread off its core.
//
// Units: nanoseconds. Threading: as dxHeuristic.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "clusters/heuristics/dxHeuristic.h"

class dxCellSizeHeuristic final : public dxHeuristic {
public:
    static constexpr int kMinCells = 5;  // per axis; the thesis chose both on all worlds of Webots
    static constexpr int kMaxCells = 20;
    static constexpr unsigned kDefaultInterval = 16;  // counted frames per measurement
    static constexpr unsigned kTrialFrames = 3;       // before an expensive candidate is left
    static constexpr double kTooExpensive = 1.5;
    static constexpr double kDrift = 0.25;      // share of the cost when it was chosen
    static constexpr double kClearGain = 0.95;  // a neighbour must cost less than this part
    static constexpr unsigned kMinHold = 16;  // intervals
    static constexpr unsigned kMaxHold = 1024;

    struct Frame {
        double ns;  // what the frame took; not a positive number: not measured, ignored
        unsigned clusters;
        unsigned entities;  // 0: not known
    };
    enum class Phase { Climb, Hold, ProbeBelow, ProbeAbove };

    // An interval of 0 frames is taken as 1.
    explicit dxCellSizeHeuristic(unsigned interval = kDefaultInterval)
        : m_interval(interval > 0 ? interval : 1) {}

    // A frame that ran with cells(); judged by the next tick, if running.
    void observe(const Frame &frame) { m_frame = frame; }

    int cells() const { return m_cells; }  // per axis, for the next frame
    double cost(int cells) const;          // ns, the last median; 0: never measured, infinite: left early
    Phase phase() const { return m_phase; }

private:
    void judge() override;
    void forget() override;

    void endClimbingStep(double cost);
    void endHolding(double cost);
    void endProbe();
    void endProbing();

    void use(int cells);
    void hold(int cells, unsigned intervals);
    bool tooExpensive(double median) const;
    double cheapestCost() const;
    int cheapest() const;
    double &costOf(int cells) { return m_cost[static_cast<std::size_t>(cells - kMinCells)]; }

    const unsigned m_interval;  // frames
    Frame m_frame{};

    Phase m_phase = Phase::Climb;
    int m_cells = kMinCells;
    std::vector<double> m_times;  // of the counted frames of this interval
    bool m_newGrid = true;        // the next frame pays for it and is not counted
    std::array<double, kMaxCells - kMinCells + 1> m_cost{};

    unsigned m_expensiveInARow = 0;     // climb
    int m_home = kMinCells;        // the number that is held, or to which a probe may return
    double m_chosenCost = 0;       // when it was chosen
    unsigned m_hold = kMinHold;    // number of intervals before the next probe
    unsigned m_held = 0;           // intervals so far
    bool m_moved = false;          // the last probe succeeded: its far neighbour may be better still
};
