#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"

#include <cmath>

namespace {

// Far above the rounding of the few operations below.
constexpr double kRoundedUp = 1 + 1e-12;

bool bounds(double number) { return number >= 0 && std::isfinite(number); }

bool apartAfter(const dxMotionBound &motion, double gap, unsigned frames) {
    return 2 * motion.reach(frames) < gap;
}

}  // namespace

bool dxMotionBound::proves() const {
    return bounds(speed) && bounds(acceleration) && bounds(step) && bounds(rounding);
}

double dxMotionBound::reach(unsigned frames) const {
    const double k = frames;
    return kRoundedUp * (k * (speed * step + rounding) + acceleration * step * step * (k * (k + 1) / 2));
}

unsigned dxFramesApart(const dxMotionBound &motion, double gap, unsigned limit) {
    if (!motion.proves()) return 0;
    // The reach grows with the frames: the first frame that is not proven apart lies in [apart, limit].
    unsigned apart = 0;
    while (apart < limit) {
        const unsigned middle = apart + (limit - apart) / 2;
        if (apartAfter(motion, gap, middle)) {
            apart = middle + 1;
        } else {
            limit = middle;
        }
    }
    return apart;
}

unsigned dxCheckFrequencyHeuristic::framesToSkip(const dxMotionBound &motion) const {
    return running() ? dxFramesApart(motion, m_gap, kMaxFrames) : 0;
}

void dxCheckFrequencyHeuristic::moved(const dxMotionBound &motion, unsigned frames) {
    if (frames == 0) return;
    const double left = motion.proves() ? m_gap - 2 * motion.reach(frames) : 0;
    // The difference is rounded to nearest: the next number below is surely not too large.
    m_gap = left > 0 ? std::nextafter(left, 0.0) : 0;
}
