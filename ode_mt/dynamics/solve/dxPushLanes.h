// The element-wise loops of a push of Dantzig's algorithm (lcp/dxDantzigRun.h), by vectors.
//
// Each reads and writes elements 0..count-1 of its arrays, and the arrays have room for whole fours of them: what lies
// behind the last element may be overwritten, and never matters.
#pragma once

#include <ode/common.h>

// product(i) = copy(i) = a(i) b(i)
void dxMultiplyLanes(const dReal *a, const dReal *b, unsigned count, dReal *product, dReal *copy);

// x(i) += length deltaX(i)
void dxAdvanceLanes(dReal *x, const dReal *deltaX, dReal length, unsigned count);

struct dxLimitPair {
    dReal low, high;

    // The one that is reached by falling, or rising: without a branch that nobody can foresee.
    dReal towards(bool isFalling) const { return (&low)[isFalling ? 0 : 1]; }
};

// Of the elements begin..end-1 the first one that reaches its limit before `length`, and before all others; `end` if there
// is none. `length` becomes its.
unsigned dxFindFirstAtLimit(const dReal *x, const dReal *deltaX, const dxLimitPair *limits, unsigned begin,
                            unsigned end, dReal &length);
