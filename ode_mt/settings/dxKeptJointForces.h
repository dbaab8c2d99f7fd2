// The forces along a joint's rows in a fast dWorldQuickStep, with which the next one may begin (docs/fast.md, "Warm start").
//
// They are in dxJoint::lambda, which upstream has for this purpose and does not use as it is built. Bits of dxJoint::flags that upstream does not use
// hold the number of the step that they are of, so that older ones are not taken for those of the last step.
//
// Threading: that of the joint.
#pragma once

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

namespace dxKeptJointForces {

constexpr unsigned kShift = 8, kBits = 23, kMask = ((1u << kBits) - 1) << kShift;

// Steps have numbers from 1 on, and begin again with 1 after the last one.
constexpr unsigned kLastStep = kMask >> kShift;

inline bool areOf(const dxJoint &joint, unsigned step) { return (joint.flags & kMask) >> kShift == step; }
inline void mark(dxJoint &joint, unsigned step) { joint.flags = (joint.flags & ~kMask) | step << kShift; }
inline void drop(dxJoint &joint) { joint.flags &= ~kMask; }

}  // namespace dxKeptJointForces
