// Empties a joint group: dJointGroupEmpty (ode.cpp) without an allocation, and with each joint prefetched. The last
// joint created is removed first, as in upstream, so that it is found at the front of its bodies' lists.
//
// Groups of several worlds may be emptied at the same time.
#pragma once

struct dxJointGroup;

// Returns false, without any effect, if there is no memory for a list of the joints.
bool dxRemoveJoints(dxJointGroup &group);
