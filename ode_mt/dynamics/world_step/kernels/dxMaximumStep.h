// The search for the maximum step of Dantzig's algorithm (exact/dxDantzigRun.h), vectorised.
//
// Arrays are padded to multiples of four elements; the padding is read, but does not affect results.
#pragma once

#include <ode/common.h>

struct dxLimitPair {
    dReal low, high;

    // Returns the limit towards which x moves, branch-free, because the direction is unpredictable.
    dReal towards(bool isFalling) const {
        static constexpr dReal dxLimitPair::*limit[] = {&dxLimitPair::high, &dxLimitPair::low};
        return this->*limit[isFalling];
    }
};

// Of the elements begin..end-1 the first one that reaches its limit before `length`, and before all others; `end` if there
// is none. `length` becomes its.
unsigned dxFindFirstAtLimit(const dReal *x, const dReal *deltaX, const dxLimitPair *limits, unsigned begin,
                            unsigned end, dReal &length);
