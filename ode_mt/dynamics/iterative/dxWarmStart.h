// With how much of the last step's forces a step begins.
#pragma once

#include <ode/common.h>

namespace dxWarmStart {

// All of them solve the equations better, but keep stacks moving: what a sweep has not yet found is a spring that settles them,
// as under upstream's solver, which begins with none (docs/iterative-solver.md has the figures).
constexpr dReal kPart = dReal(0.75);

}  // namespace dxWarmStart
