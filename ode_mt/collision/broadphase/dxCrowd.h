// A space of which so many pairs overlap (dxPairLimit) that keeping them costs more time and memory than testing all of
// its geoms against each other at each call, as upstream does.
#pragma once

#include "collision/broadphase/dxBroadPhaseChoice.h"

class dxCrowd {
public:
    bool isOne() const { return m_calls != 0; }
    void become() { m_calls = dxBroadPhaseThresholds::kCallsOfCrowd; }
    // Returns whether it is time to count again. Requires one call at the beginning of each call beyond the limit.
    bool isOver() { return --m_calls == 0; }

private:
    int m_calls = 0;  // number of calls for which the space is still walked
};
