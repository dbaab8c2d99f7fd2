// What a body has before a step, and what it weighs.
#pragma once

#include <ode/ode.h>

namespace quality {

// Saved and restored as bytes.
struct BodyState {
    dVector3 position, linear, angular, force, torque;
    dQuaternion rotation;
    int isEnabled;
};

BodyState stateOf(dBodyID body);
void restore(dBodyID body, const BodyState &state);

// 1 / mass and the inverse of the inertia in world axes, row by row; 0 if kinematic.
struct InverseInertia {
    double mass = 0;
    double tensor[3][3] = {};

    // inv(M) applied to force and torque.
    void apply(const double load[6], double change[6]) const;
};

InverseInertia inverseInertiaOf(dBodyID body);

}  // namespace quality
