#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"

#include <cmath>

unsigned dxCheckFrequencyHeuristic::framesToSkip(const dxMotionBound &motion) const {
    return running() ? dxFramesApart(motion, m_gap, kMaxFrames) : 0;
}

void dxCheckFrequencyHeuristic::moved(const dxMotionBound &motion, unsigned frames) {
    if (frames == 0) return;
    const double left = motion.proves() ? m_gap - 2 * motion.reach(frames) : 0;
    // The difference is rounded to nearest: the next number below is surely not too large.
    m_gap = left > 0 ? std::nextafter(left, 0.0) : 0;
}
