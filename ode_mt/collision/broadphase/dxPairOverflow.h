// A space of which so many pairs overlap (dxPairLimit) that keeping them costs more time and memory than testing all of
// its geoms against each other at each call, as upstream does.
#pragma once

#include "collision/broadphase/dxBroadphaseChoice.h"

class dxPairOverflow {
public:
    bool isActive() const { return m_calls != 0; }
    void begin() { m_calls = dxBroadphaseThresholds::kCallsOfCrowd; }
    // Returns whether it is time to count again. Requires one call at the beginning of each call beyond the limit.
    bool isTimeToCount() { return --m_calls == 0; }

private:
    int m_calls = 0;  // number of calls for which the space is still walked
};
