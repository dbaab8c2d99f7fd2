// The support function of convex geoms for libccd: the point that is furthest along a direction.
//
// Like upstream's (ccdSupportConvex, ode/src/collision_libccd.cpp), it returns the first of the furthest points, by the
// same sums, but branch-free: which point is the furthest is unpredictable, and a pair of convex geoms makes dozens of
// calls.
#pragma once

#include <ccd/quat.h>
#include <ode/odemath.h>

#include <cstddef>

#include "config.h"
#include "collision_std.h"

// Upstream's ccd_convex_t, which is known in its file alone. That file is the one release that the fork is made of
// (ode/releases/), and every pair with a convex geom in the exactness suite depends on it.
struct dxCcdConvex {
    ccd_vec3_t position;
    ccd_quat_t rotation, inverseRotation;
    const dxConvex *convex;
};

// If the distance of every point is NaN, `support` keeps its value before it is rotated.
inline void dxSupportConvex(const dxCcdConvex &object, const ccd_vec3_t &direction, ccd_vec3_t &support) {
    ccd_vec3_t local = direction;
    ccdQuatRotVec(&local, &object.inverseRotation);
    const dReal *const points = object.convex->points, *furthest = nullptr;
    ccd_real_t most = -CCD_REAL_MAX;
    for (std::size_t i = 0; i < object.convex->pointcount; ++i) {
        const dReal *const point = points + 3 * i;
        ccd_vec3_t place;
        ccdVec3Set(&place, point[0], point[1], point[2]);
        const ccd_real_t distance = ccdVec3Dot(&local, &place);
        furthest = distance > most ? point : furthest;
        most = distance > most ? distance : most;
    }
    if (furthest != nullptr) ccdVec3Set(&support, furthest[0], furthest[1], furthest[2]);
    ccdQuatRotVec(&support, &object.rotation);
    ccdVec3Add(&support, &object.position);
}
