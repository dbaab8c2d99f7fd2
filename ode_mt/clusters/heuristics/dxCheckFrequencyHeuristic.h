// How many frames a check of all members can be left out, because nothing it looks for can have happened.
// Used twice (thesis 10.1): for the crossover frequency and for the declustering frequency.
//
//   crossover      gap: smallest distance between members of different clusters. None is missed.
//   declustering   gap: smallest change of a distance that could cut a cluster in two. A late split would
//                  change no result, but none comes late.
//
//   frame:  if (heuristic.framesToSkip(motion) == 0) heuristic.checked(gap found by the check);
//           step
//           heuristic.moved(motion);
//
// checked() records the gap. moved() takes from it what both of two members may have travelled.
// framesToSkip() says for how many frames, this one first, the rest of the gap lasts if `motion` goes on to
// hold; a caller that knows it will hold need not ask in between.
//
// In a world with contacts nothing bounds the acceleration in advance. There the caller asks every frame and
// hands moved() the largest speed that did move the members, with an acceleration of 0: the one after the
// step, but before damping, which ODE applies after it has moved a body.
//
// What a step does not do, the caller must report with invalidate(): a pose set by the user, a geom or
// joint added, resized or enabled, a static geom moved. While the heuristic is not running it proves nothing
// (0: check now), yet what moves still counts.
//
// The thesis proposes to tune these frequencies by experience. Here a bound proves each frame that is left
// out (dxMotionBound), because results must not depend on a heuristic.
#pragma once

#include "clusters/heuristics/dxHeuristic.h"
#include "clusters/heuristics/dxMotionBound.h"

class dxCheckFrequencyHeuristic final : public dxHeuristic {
public:
    static constexpr unsigned kMaxFrames = 1000;  // a world at rest is looked at that often

    // A check found nothing nearer than `gap`, in metres; infinite: there are no two members. The gap must
    // not be rounded up. NaN or not positive: something has met, the next frame checks again.
    void checked(double gap) { m_gap = gap > 0 ? gap : 0; }

    // 0: check now.
    unsigned framesToSkip(const dxMotionBound &motion) const;

    // Members have moved for some frames, within this bound.
    void moved(const dxMotionBound &motion, unsigned frames = 1);

    void invalidate() { m_gap = 0; }

    double gap() const { return m_gap; }  // m, what is left of it

private:
    void judge() override {}
    void forget() override { invalidate(); }

    double m_gap = 0;
};
