#include "upstream_solve_l1.h"

#include <ode/common.h>
#include <ode/matrix.h>

// Upstream's headers do not include what they use: this is the order of its lcp.cpp.
#include "config.h"

#include "error.h"
#include "threaded_solver_ldlt.h"

#include "fastlsolve_impl.h"
#include "fastltsolve_impl.h"

template <unsigned Stride>
void upstreamSolveStraight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    solveL1Straight<Stride>(L, B, rowCount, rowSkip);
}

template <unsigned Stride>
void upstreamSolveTransposed(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip) {
    solveL1Transposed<Stride>(L, B, rowCount, rowSkip);
}

template void upstreamSolveStraight<1>(const dReal *, dReal *, unsigned, unsigned);
template void upstreamSolveStraight<2>(const dReal *, dReal *, unsigned, unsigned);
template void upstreamSolveTransposed<1>(const dReal *, dReal *, unsigned, unsigned);
template void upstreamSolveTransposed<2>(const dReal *, dReal *, unsigned, unsigned);
