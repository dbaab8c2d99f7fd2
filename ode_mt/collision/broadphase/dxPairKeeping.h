// Whether a space keeps its pairs from call to call, or finds all of them anew at each call as upstream does.
//
// Keeping pairs pays where few of them change. Where many boxes overlap and some of these move, it costs more than comparing every
// two boxes with SIMD (dxPairRows and the classes derived from it). Both costs are estimated at each call, from the numbers of geoms
// and pairs; in spaces of many geoms the first is corrected by the clock. The space changes to the other way when that would have saved
// as much as the change costs: so it costs at most a few times the cheaper of the two over any number of calls, whatever the program
// does.
//
// Source: Borodin, Linial and Saks, "An optimal on-line algorithm for metrical task systems", Journal of the ACM 39, 1992.
#pragma once

#include <cstddef>

#include "collision/broadphase/dxBroadphaseChoice.h"

class dxPairKeeping {
public:
    explicit dxPairKeeping(dxPairOrder order) : m_order(order) {}

    bool isKept() const { return m_isKept; }

    // Requires a call after each call of dSpaceCollide, with its work. May change isKept() for the next one.
    void note(const dxPairWork &work);
    // Takes the measured time of keeping the pairs at this call, before note(): the estimate does not depend on how the boxes lie.
    void noteTime(const dxPairWork &work, double ns);
    // Requires a call when there are more pairs than may be kept. Then none is kept until a call has found at most half of the
    // limit.
    void overflow();

private:
    void noteFew(std::size_t changed);
    void noteKept(const dxPairWork &work);
    void noteAnew(const dxPairWork &work);
    void change();

    dxPairOrder m_order;
    bool m_isKept = true;
    unsigned m_timed = 0;      // number of calls that were timed, at most kCallsOfAverage
    double m_factor = 1;       // measured time of keeping, over the estimate
    unsigned m_keptCalls = 0;  // number of calls before enough were timed
    int m_restedCalls = 0;     // number of calls in a row without a change, of a space of few geoms
    double m_saved = 0;        // ns that the other way would have saved, since it first would have
};
