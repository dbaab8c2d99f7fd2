// With how much of the last step's forces a step begins.
#pragma once

#include <algorithm>

#include <ode/common.h>

namespace dxWarmStart {

// All of them solve the equations better, but keep stacks moving: what a sweep has not yet found is a spring that settles them,
// as under upstream's solver, which begins with none (docs/iterative-solver.md has the figures).
constexpr dReal kPart = dReal(0.75);

// A force that has corrected much of a contact's depth is not wanted again: with kPart of all forces columns of six boxes move more from erp 0.25 on, and
// fall with 0.8. Up to this erp, the default, they do not.
constexpr dReal kMostErp = dReal(0.2);

// Of a contact's force.
inline dReal partFor(dReal erp) {
    return erp <= kMostErp ? kPart : kPart * std::max(dReal(0), (1 - erp) / (1 - kMostErp));  // NaN: none
}

// With steps of two sizes in turns, whose forces are kept, six boxes fall that stand without: at a ratio of 3 one column in twelve, of 4 all of them; at 2
// they move more.
constexpr dReal kMostLonger = dReal(1.75);

inline bool isLike(dReal stepSize, dReal last) { return stepSize < kMostLonger * last && last < kMostLonger * stepSize; }

}  // namespace dxWarmStart
