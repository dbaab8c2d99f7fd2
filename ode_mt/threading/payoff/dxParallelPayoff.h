// Does parallelism pay? How every such decision is made, the words for it, and the parts that all decisions have in common.
//
//   overhead         what parallel work costs beside the work itself: waking workers, waiting for the last of them.
//                    Never assumed, always measured, as a part of whole steps or calls
//   moving average   of measured times: the machine and the world change, single times are disturbed
//   margin           what is predicted or was measured has to be better by this part to be taken (hysteresis)
//   probe            some steps or calls in a row in the way that is not in use, to measure it anew. The first of them are
//                    cold: workers sleep, their caches hold other data
//   retry interval   until the next probe: twice as long after a probe that did not pay, short again after what paid
//   loss limit       the part of the caller's time that probes may cost in the long run
//
// Two classes decide:
//
//                    dxCostModel                               dxSharingPolicy
//   for              the steps of all worlds                   work that comes again and again, as a space's collision
//   question         how many workers?                         shared or alone?
//   answer from      a model of the islands' costs, with the   the average times of both ways
//                    averages of scale and overhead
//   probe            8 steps, 2 cold; the median counts        3 calls, 1 cold; the average counts. Of what is new to
//                                                              other processes 8, 3 cold
//   retry interval   time on the caller: the overhead fades    48 to 768 calls; 8 and more if calls become slower
//   loss limit       0.4 %                                     1/32, by a debt that is paid back
//
// There are two because one time per way is not enough for steps: worlds and islands differ from step to step, so that what was
// measured of one step has to predict another. And a model is not possible for calls: most of their cost is the program's
// callbacks, of which nothing is known beforehand.
#pragma once

#include <algorithm>

// Exponential: `weight` is the part of the newest value, from 0 to 1.
inline double dxMovingAverage(double mean, double newest, double weight) { return mean + weight * (newest - mean); }

// Hysteresis: `margin` is the part of the other time that this one has to stay below.
inline bool dxPaysClearly(double ns, double otherNs, double margin) { return ns < margin * otherNs; }

template <class Interval>
struct dxRetryLimits {
    Interval shortest, longest;

    Interval afterFailure(Interval interval) const { return std::clamp<Interval>(2 * interval, shortest, longest); }
    // `part`: of the interval that is left.
    Interval afterSuccess(Interval interval, double part) const {
        return std::clamp<Interval>(static_cast<Interval>(part * interval), shortest, longest);
    }
};
