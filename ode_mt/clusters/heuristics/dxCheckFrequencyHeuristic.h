// How many frames a check of all members can be left out, because nothing it looks for can have happened; and the motion bound that proves it.
// The heuristic is used twice (thesis 10.1): for the crossover frequency and for the declustering frequency.
//
//   crossover      gap: smallest distance between members of different clusters. No crossover is missed.
//   declustering   gap: smallest change of a distance that could split a cluster. A late split would
//                  change no result, but none comes late.
//
//   frame:  if (heuristic.framesToSkip(motion) == 0) heuristic.checked(gap found by the check);
//           step
//           heuristic.moved(motion);
//
// checked() records the gap. moved() subtracts from it how far both of two members may have moved.
// framesToSkip() returns for how many frames, beginning with this one, the rest of the gap lasts if `motion` continues to
// hold; a caller that knows that it will hold need not ask in between.
//
// In a world with contacts nothing bounds the acceleration in advance. There the caller asks every frame and
// gives moved() the largest speed that did move the members, with an acceleration of 0: the speed after the
// step, but before damping, which ODE applies after it has moved a body.
//
// The caller must report with invalidate() what a step does not do: a pose set by the user, a geom or
// joint added, resized or enabled, a static geom moved. While the heuristic is not running it proves nothing
// (0: check now), but motion is still subtracted.
//
// The thesis proposes to tune these frequencies by experience. Here a bound proves each frame that is left
// out, because results must not depend on a heuristic.
//
// The bound: a frame moves a point by its speed at the end of the frame times the time step (ODE integrates velocities
// first), and the speed grows by at most acceleration x step a frame. So no point of a member moves further
// in k frames of step h than
//
//   reach(k) = k (v h + r) + a h² k (k + 1) / 2
//
// and two members whose gap g (smallest distance between any two that are to be kept apart) is larger than
// 2 reach(k) have not met at any time in these frames: each would have to move half of the gap.
// Numbers are rounded so that the reach becomes larger, never smaller.
//
// Units: SI. Threading: as dxHeuristic.
#pragma once

#include "clusters/heuristics/dxHeuristic.h"

// For members that turn, the speed is that of the fastest point: |linear velocity| + |angular velocity| x radius.
struct dxMotionBound {
    double speed;         // m/s, of the fastest member when the frames begin
    double acceleration;  // m/s², by which that speed can grow. 0 if the speed bounds the frames themselves
    double step;          // s, of a frame
    double rounding;      // m, by which rounding moves a member in a frame: half an ulp of the largest coordinate

    // Returns false if a number is NaN, infinite or negative: such motion bounds nothing.
    bool proves() const;

    double reach(unsigned frames) const;  // m; infinite or NaN if it is too large for a double
};

// Returns for how many frames, at most `limit`, members with this gap need no check: the first frame's positions are
// the present ones, each later frame's those after one more step. 0: they may have met already.
unsigned dxFramesApart(const dxMotionBound &motion, double gap, unsigned limit);

class dxCheckFrequencyHeuristic final : public dxHeuristic {
public:
    static constexpr unsigned kMaxFrames = 1000;  // after which even a world at rest is checked

    // Records that a check found nothing nearer than `gap`, in metres; infinite: there are no two members. Requires a gap that was
    // not rounded up. NaN or not positive: members have met, the next frame checks again.
    void checked(double gap) { m_gap = gap > 0 ? gap : 0; }

    // Returns 0 if a check is due now.
    unsigned framesToSkip(const dxMotionBound &motion) const;

    // Records that members have moved for some frames, within this bound.
    void moved(const dxMotionBound &motion, unsigned frames = 1);

    void invalidate() { m_gap = 0; }

    double gap() const { return m_gap; }  // m, what is left of it

private:
    void judge() override {}
    void forget() override { invalidate(); }

    double m_gap = 0;
};
