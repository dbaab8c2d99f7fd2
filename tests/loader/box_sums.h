// Sums over static boxes, to compare a world with the table of its facts.
#pragma once

#include "small_world.h"

namespace small_world {

struct BoxSums {
    int count = 0;
    Vector3 center;    // sum of the centres
    double volume = 0;  // sum of the volumes
};

inline BoxSums sumOfStaticBoxes(const worlds::SdfScene &scene) {
    BoxSums sums;
    for (const dGeomID geom : scene.inventory().geoms) {
        if (dGeomGetBody(geom) || dGeomGetClass(geom) != dBoxClass) continue;
        dVector3 sides;
        dGeomBoxGetLengths(geom, sides);
        const dReal *center = dGeomGetPosition(geom);
        ++sums.count;
        sums.center += Vector3{center[0], center[1], center[2]};
        sums.volume += sides[0] * sides[1] * sides[2];
    }
    return sums;
}

}  // namespace small_world
