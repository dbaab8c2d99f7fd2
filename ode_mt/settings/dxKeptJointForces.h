// The forces along a joint's rows in a fast dWorldQuickStep, with which the next one may begin (docs/fast.md, "Warm start").
//
// They are in dxJoint::lambda, which upstream has for this purpose and does not use as it is built. Bits of dxJoint::flags that upstream does not use
// hold the number of rows, and of the step that they are of, so that older ones are not taken for those of the last step, nor those of other rows: a
// joint at its stop has more.
//
// Threading: that of the joint.
#pragma once

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

namespace dxKeptJointForces {

constexpr unsigned kRowsShift = 8, kStepShift = 11, kMask = 0x7fffff00;

// Steps have numbers from 1 on, and begin again with 1 after the last one.
constexpr unsigned kLastStep = kMask >> kStepShift;

inline unsigned marksOf(unsigned step, unsigned rows) { return step << kStepShift | rows << kRowsShift; }
inline bool areOf(const dxJoint &joint, unsigned step, unsigned rows) { return (joint.flags & kMask) == marksOf(step, rows); }
inline void mark(dxJoint &joint, unsigned step, unsigned rows) { joint.flags = (joint.flags & ~kMask) | marksOf(step, rows); }
inline void drop(dxJoint &joint) { joint.flags &= ~kMask; }

}  // namespace dxKeptJointForces
