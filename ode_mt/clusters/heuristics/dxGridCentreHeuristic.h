// Where the centre of the grid lies (thesis 10.1, which names the parameter and gives no rule).
//
// The centre is the one that the caller offers: the middle of the extent of nearly all dynamic members (dxFitGrid), so that one member
// far away, or one that falls for ever, does not move it. Tried and dropped: the median of the members, which lies in one of two
// groups. The centre is moved only
//   - when more than kOutside of the members are outside the grid, or the median frame costs more than (1 + kDrift)
//     times what it cost after the last decision;
//   - if the offered centre is then further than kHysteresis cells from the present one on some axis: a move within a cell
//     hardly changes which members share a cell, and costs a new grid;
//   - at least kMinRest frames after the last decision. The rest doubles, up to kMaxRest, each time the reason
//     still holds at its end (moving the grid does not help members that are spread wider than
//     it), and is short again once the reason has gone.
// A centre is requested (wantsCentre) only in the frames that decide, since it costs a pass over the members.
//
// Bound: at most one such pass and one new grid in kMinRest frames, once the centre is set.
//
// The grid affects speed, never the result, so any centre is right. Not done: looking
// for cell boundaries that fall between two members (the thesis's figure 10.2).
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

    // Returns whether a centre should be offered after this tick. True from the start until the centre was set once.
    bool wantsCentre() const { return m_wantsCentre && running(); }

    // Returns whether the centre has moved. Refuses a centre that is not wanted or not finite, and a cell edge that is not positive and finite.
    bool offer(const Point &centre, double cellEdge);

    const Point &centre() const { return m_centre; }  // 0, 0, 0 until one was set
    unsigned rest() const { return m_rest; }          // number of frames between decisions, at present

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
    bool m_wantsCentre = false;

    unsigned m_rest = kMinRest;  // frames between decisions
    unsigned m_rested = 0;
    std::vector<double> m_times;
    double m_cost = 0;            // median of the last interval; 0: none yet
    double m_costAtDecision = 0;  // of the first interval after the last decision; 0: none yet
};
