// A space of which so many pairs overlap (dxPairLimit) that keeping them costs more time and memory than testing all of
// its geoms against each other at each call, as upstream does.
#pragma once

#include "collision/broadphase/dxBroadPhaseChoice.h"

class dxCrowd {
public:
    bool isOne() const { return m_calls != 0; }
    void become() { m_calls = dxBroadPhaseThresholds::kCallsOfCrowd; }
    // At the beginning of a call of a crowd. True: it is time to count again.
    bool isOver() { return --m_calls == 0; }

private:
    int m_calls = 0;  // that it is to be walked yet
};
