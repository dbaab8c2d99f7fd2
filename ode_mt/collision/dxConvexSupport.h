// The support function of convex geoms for libccd: which of the points lies furthest along a direction.
//
// As upstream's (ccdSupportConvex, ode/src/collision_libccd.cpp), the first of those that lie furthest, by the same sums;
// but without a branch for each point. Which point is the furthest changes from call to call, and a pair of convex geoms
// makes dozens of calls.
#pragma once

#include <ccd/quat.h>
#include <ccd/vec3.h>
#include <ode/odemath.h>

#include <cstddef>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "collision_std.h"

// The beginning of upstream's ccd_convex_t, which is known in its file alone.
struct dxCcdConvex {
    ccd_vec3_t position;
    ccd_quat_t rotation, inverseRotation;
    const dxConvex *convex;
};

// `support` stays as it is, before it is rotated, where no point has a number for its distance.
inline void dxSupportConvex(const dxCcdConvex &object, const ccd_vec3_t &direction, ccd_vec3_t &support) {
    ccd_vec3_t local = direction;
    ccdQuatRotVec(&local, &object.inverseRotation);
    const dReal *const points = object.convex->points, *furthest = nullptr;
    ccd_real_t most = -CCD_REAL_MAX;
    for (std::size_t i = 0; i < object.convex->pointcount; ++i) {
        const dReal *const point = points + 3 * i;
        const ccd_real_t distance = local.v[0] * point[0] + local.v[1] * point[1] + local.v[2] * point[2];
        furthest = distance > most ? point : furthest;
        most = distance > most ? distance : most;
    }
    if (furthest != nullptr) ccdVec3Set(&support, furthest[0], furthest[1], furthest[2]);
    ccdQuatRotVec(&support, &object.rotation);
    ccdVec3Add(&support, &object.position);
}
