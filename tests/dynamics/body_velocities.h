// Linear and angular velocities of bodies, one after the other.
#pragma once

#include <ode/ode.h>

#include <vector>

inline std::vector<dReal> velocitiesOf(const std::vector<dBodyID> &bodies) {
    std::vector<dReal> all;
    for (const dBodyID body : bodies) {
        all.insert(all.end(), dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
        all.insert(all.end(), dBodyGetAngularVel(body), dBodyGetAngularVel(body) + 3);
    }
    return all;
}
