// Whether a space keeps its pairs from call to call, or finds all of them anew at each call as upstream does.
//
// To keep pairs pays where few of them change. Where many boxes overlap and some of these move, it costs more than to compare every
// two boxes with SIMD (dxPairRows and the classes derived from it). Both costs are estimated at each call, from the numbers of geoms
// and pairs; in spaces of many geoms the first is corrected by the clock. The space changes its way when the other one would have saved
// as much as the change costs: then it costs at most a few times the cheaper of the two over any number of calls, whatever the program
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

    // Requires a call after each call of dSpaceCollide, with what that did. May change isKept() for the next one.
    void note(const dxPairWork &work);
    // Takes what it has cost by the clock to keep the pairs at this call, before note(): the estimate knows nothing of how boxes lie.
    void noteTime(const dxPairWork &work, double ns);
    // Requires a call when there are more pairs than may be kept. None is kept then until a call has found no more than half of the
    // limit.
    void overflow();

private:
    void noteFew(std::size_t changed);
    void noteKept(const dxPairWork &work);
    void noteAnew(const dxPairWork &work);
    void change();

    dxPairOrder m_order;
    bool m_isKept = true;
    unsigned m_timed = 0;   // calls, no more than make an average
    double m_factor = 1;    // of what keeping costs to what is estimated
    unsigned m_keptCalls = 0;  // while the clock has told too little
    int m_restedCalls = 0;  // in a row, of a space of few geoms
    double m_saved = 0;   // ns that the other way would have saved, since it would have begun to
};
