// Marks joints that have been attached since the last search for islands.
//
// Code of the user's that runs within a step (moved-callbacks, handlers of messages, the step's allocator) may attach joints to
// bodies of islands that are not stepped yet, including joints of such islands. Upstream's exact step finds a new joint in its
// bodies' lists, and takes it for the joint of the island that its tag numbers (Stage2c in step.cpp). Both of its steppers take
// a body of another island for one of their own that has the same number. So upstream's steppers step such islands, which a step finds
// by the marks.
//
// What a joint keeps of its last step is of its last bodies, and is dropped (dxKeptJointForces).
//
// Most steps have none. So that these need not test all their joints, the world is marked as well: in the fourth number of
// its gravity, which upstream sets to zero and never reads.
//
// Threading: that of upstream's dJointAttach.
#pragma once

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "seams/upstream.h"
#include "settings/dxKeptJointForces.h"

namespace dxJointAttachment {

// A bit of dxJoint::flags that upstream does not use.
constexpr unsigned kMark = 1u << 31;

inline void attach(dxJoint *joint, dxBody *body1, dxBody *body2) {
    dxUpstreamJointAttach(joint, body1, body2);
    if (joint == nullptr) return;
    joint->flags |= kMark;
    dxKeptJointForces::drop(*joint);
    if (joint->world != nullptr && joint->world->gravity[3] == 0) joint->world->gravity[3] = 1;
}

// Returns whether any joint of the world has been attached since forgetAll().
inline bool hasAny(const dxWorld &world) { return world.gravity[3] != 0; }

// Requires forget() for all joints of the world.
inline void forgetAll(dxWorld &world) { world.gravity[3] = 0; }

inline void forget(dxJoint &joint) { joint.flags &= ~kMark; }

inline bool isRecent(const dxJoint &joint) { return (joint.flags & kMark) != 0; }

// Returns whether a joint of the body is recent: the joint that was attached last is the first of its bodies' lists.
inline bool hasRecent(const dxBody &body) { return body.firstjoint != nullptr && isRecent(*body.firstjoint->joint); }

}  // namespace dxJointAttachment
