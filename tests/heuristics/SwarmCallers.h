// How a frame may use the check frequency rule, and what came of it.
#pragma once

#include <algorithm>

#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"
#include "Swarm.h"

struct Outcome {
    unsigned checks = 0, missed = 0, meetings = 0, overstated = 0;
};

inline constexpr unsigned kFrames = 1500;

// A caller that asks every frame. It hands in the motion before the step with a bound on what is added to it,
// or, with `After`, the motion after the step, which needs none.
template <class Real, bool After>
Outcome askEveryFrame(Swarm<Real> swarm) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    Outcome outcome;
    for (unsigned frame = 0; frame < kFrames; ++frame) {
        const double gap = swarm.gap();
        const bool met = !(gap > 0);
        outcome.meetings += met;
        if (heuristic.framesToSkip(swarm.motion()) == 0) {
            ++outcome.checks;
            heuristic.checked(gap);
        } else {
            outcome.missed += met;
        }
        outcome.overstated += heuristic.gap() > std::max(gap, 0.0);
        dxMotionBound motion = swarm.motion();
        swarm.step();
        if (After) {
            motion = swarm.motion();
            motion.acceleration = 0;
        }
        heuristic.moved(motion);
    }
    return outcome;
}

// A caller that takes the number of frames at its word.
template <class Real>
Outcome trust(Swarm<Real> swarm) {
    dxCheckFrequencyHeuristic heuristic;
    heuristic.start();
    Outcome outcome;
    for (unsigned frame = 0; frame < kFrames;) {
        const dxMotionBound motion = swarm.motion();
        if (heuristic.framesToSkip(motion) == 0) {
            ++outcome.checks;
            outcome.meetings += !(swarm.gap() > 0);
            heuristic.checked(swarm.gap());
        }
        const unsigned skipped = std::max(heuristic.framesToSkip(motion), 1u);
        for (unsigned i = 0; i < skipped; ++i, ++frame) {
            if (i > 0 && !(swarm.gap() > 0)) ++outcome.missed;
            swarm.step();
        }
        heuristic.moved(motion, skipped);
        outcome.overstated += heuristic.gap() > std::max(swarm.gap(), 0.0);
    }
    return outcome;
}
