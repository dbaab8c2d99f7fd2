// The triangular solves of the exact step. ode/seams/lcp.h puts them in the place of upstream's templates
// of ode/src/fastlsolve_impl.h and fastltsolve_impl.h; docs/exact.md tells why the bits are the same.
//
// L is rowCount x rowCount, lower triangular, with ones on its diagonal, which is not read; its rows start
// rowSkip elements apart. Element i of B is at B[i * b_stride]; it becomes element i of the solution.
// Neither needs an alignment; L and B must not overlap. rowCount is at least 1.
#pragma once

#include <ode/common.h>

#include "dynamics/world_step/kernels/dxTriangle.h"

class dxTaskRunner;

// B := L^-1 B. Instances for b_stride 1 and 2.
template <unsigned b_stride>
void dxSolveL1Straight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip);

// B := L^-T B. Instances for b_stride 1 and 2.
template <unsigned b_stride>
void dxSolveL1Transposed(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip);

// The same for b_stride 1 with skyline storage: columns before the skyline are taken for zero, which is exact if
// everything is finite, no sum overflows, and results are rounded to nearest.
void dxSolveL1Straight(const dReal *L, dReal *B, unsigned rowCount, unsigned rowSkip, const dxSkyline &skyline);

// Row i of L is at L[i]. `runner`: null for the calling thread alone.
void dxSolveL1Transposed(const dReal *const *L, dReal *B, unsigned rowCount, const dxSkyline &skyline,
                         dxTaskRunner *runner = nullptr);

namespace dxSolve {

// Number of columns that one worker solves while others may wait for some of them.
constexpr unsigned kSharedPanel = 64;

}  // namespace dxSolve
