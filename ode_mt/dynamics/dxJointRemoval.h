// Empties a joint group: dJointGroupEmpty (ode.cpp) without an allocation, and with each joint asked of the
// memory before its turn. The last joint made goes first, as upstream, so that it is found at the front of
// its bodies' lists.
//
// Groups of several worlds may be emptied at the same time.
#pragma once

struct dxJointGroup;

// False: there is no memory for a list of the joints, and nothing is done.
bool dxRemoveJoints(dxJointGroup &group);

// Frees what is kept from call to call (dCloseODE, unloading).
void dxForgetJointRemoval();
