// An LCP as upstream's step hands it over: what dxSolveDantzig (dxDantzig.h) is given.
#pragma once

#include <ode/common.h>

struct dxDantzigProblem {
    unsigned n;
    const dReal *A;  // lower triangle
    dReal *pairsBX;
    unsigned unbounded;
    const dReal *pairsLoHi;
    const int *normalOf;
};
