// The contact that colliders of the tests' own classes give.
#pragma once

#include <ode/ode.h>

// Half way between two geoms; returns the number of contacts.
inline int contactHalfWay(dGeomID o1, dGeomID o2, const dVector3 normal, dReal depth, dContactGeom &contact) {
    const dReal *const a = dGeomGetPosition(o1), *const b = dGeomGetPosition(o2);
    for (int i = 0; i < 3; ++i) {
        contact.pos[i] = (a[i] + b[i]) / 2;
        contact.normal[i] = normal[i];
    }
    contact.depth = depth;
    contact.g1 = o1;
    contact.g2 = o2;
    contact.side1 = contact.side2 = -1;
    return 1;
}
