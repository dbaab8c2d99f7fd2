// Where the centre of the grid lies (thesis 10.1, which names the parameter and gives no rule).
//
// The centre is put where the caller offers it: at the middle of what nearly all dynamic members span (dxFitGrid), so that one member
// far away, or one that falls for ever, does not drag it along. Tried and dropped: the median of the members, which lies in one of two
// groups. It is moved only
//   - when more than kOutside of the members are outside the grid, or the median frame has become dearer by
//     more than kDrift since the last decision;
//   - if what is offered is then further than kHysteresis cells from the centre on some axis: a move within a cell
//     hardly changes who shares one, and costs a new grid;
//   - at least kMinRest frames after the last decision. Rest doubles, up to kMaxRest, each time the reason is
//     still there at its end (members that are spread wider than the grid are not helped by moving
//     it) and is short again once it has gone.
// It is asked for (wantsMedian, the name is older) only in the frames that decide, since it costs a pass over the members.
//
// Bound: at most one such pass and one new grid in kMinRest frames, once the centre is set.
//
// The grid decides who is tested with whom how fast, never the result, so any centre is right. What this does
// not do: look for cell boundaries that fall between two members (the thesis's figure 10.2).
//
// Units: metres, nanoseconds. Threading: as dxHeuristic.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "clusters/heuristics/dxHeuristic.h"

class dxGridCentreHeuristic final : public dxHeuristic {
public:
    static constexpr double kOutside = 0.1;     // share of the dynamic members
    static constexpr double kDrift = 0.25;      // share of the frame's cost
    static constexpr double kHysteresis = 1;    // cells
    static constexpr unsigned kMinRest = 32;  // frames
    static constexpr unsigned kMaxRest = 512;
    static constexpr unsigned kInterval = 16;  // measured frames to a median

    using Point = std::array<double, 3>;
    struct Frame {
        double outside;  // share of the dynamic members outside the grid, 0 to 1; NaN counts as 0
        double ns;       // what the frame took; not a positive number: not measured, ignored
    };

    // Judged by the next tick, if running.
    void observe(const Frame &frame) { m_frame = frame; }

    // After a tick: hand the median in now. From the start, until the centre was set once.
    bool wantsMedian() const { return m_wantsMedian && running(); }

    // True if the centre has moved. Refused, with false, if not wanted, not finite, or without a cell.
    bool offer(const Point &median, double cellEdge);

    const Point &centre() const { return m_centre; }  // 0, 0, 0 until there was a median
    unsigned rest() const { return m_rest; }          // frames, at present

private:
    void judge() override;
    void forget() override;

    void measure();
    bool needsMove() const;
    bool farFromCentre(const Point &point, double cellEdge) const;
    void beginRest(unsigned frames);

    Frame m_frame{};
    Point m_centre{};
    bool m_placed = false;  // the centre was set once
    bool m_wantsMedian = false;

    unsigned m_rest = kMinRest;  // frames between decisions
    unsigned m_rested = 0;
    std::vector<double> m_times;
    double m_cost = 0;            // median of the last interval; 0: none yet
    double m_costAtDecision = 0;  // of the first interval after the last decision; 0: none yet
};
