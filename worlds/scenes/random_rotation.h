// Turns a body any way.
#pragma once

#include "scenes/generator.h"

namespace scenes {

// Three draws; by Euler angles, so not evenly spread over all rotations.
inline void turnAtRandom(dBodyID body, Generator &random) {
    const dReal roll = random.between(-3, 3), pitch = random.between(-3, 3), yaw = random.between(-3, 3);
    dMatrix3 rotation;
    dRFromEulerAngles(rotation, roll, pitch, yaw);
    dBodySetRotation(body, rotation);
}

}  // namespace scenes
