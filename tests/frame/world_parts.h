// What the worlds of these tests have in common.
#pragma once

#include <ode/ode.h>

#include <vector>

// Joints at up to four places where two geoms touch; how many.
inline int joinWhereTheyTouch(dWorldID world, dJointGroupID group, const dSurfaceParameters &surface, dGeomID o1,
                              dGeomID o2) {
    constexpr int kMaxContacts = 4;
    dContact contacts[kMaxContacts] = {};
    const int count = dCollide(o1, o2, kMaxContacts, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface = surface;
        dJointAttach(dJointCreateContact(world, group, &contacts[i]), dGeomGetBody(o1), dGeomGetBody(o2));
    }
    return count;
}

inline void append(std::vector<dReal> &numbers, const dReal *values, int count) {
    numbers.insert(numbers.end(), values, values + count);
}

// Pose and velocities.
inline void appendMotion(std::vector<dReal> &numbers, dBodyID body) {
    append(numbers, dBodyGetPosition(body), 3);
    append(numbers, dBodyGetQuaternion(body), 4);
    append(numbers, dBodyGetLinearVel(body), 3);
    append(numbers, dBodyGetAngularVel(body), 3);
}
