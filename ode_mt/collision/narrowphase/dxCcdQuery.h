// What upstream's libccd collider calls instead of libccd's own functions (ode/seams/collision_libccd.h): the iterative overlap test of two shapes
// with a limit of iterations, and the support function of convex geoms.
#pragma once

#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <ode/odemath.h>

#include <cstddef>

#include "config.h"
#include "collision_std.h"

// libccd's overlap test (Minkowski portal refinement: Snethen, "XenoCollide", Game Programming Gems 7, 2008), with a limit of iterations.
//
// Each iteration calls the support functions; where numbers are too large for progress, the iteration never ends. A
// callback that collides such a pair never returns, with upstream's library as with ours. But the narrow-phase prefetch
// (dxNarrowphasePrefetch) computes contacts that no callback may request: there a dxUpstreamInterrupted leaves the iteration at the limit.
class dxCcdQuery {
public:
    // These are libccd's functions of these names, with the thread's limit, if it has one.
    static int intersect(const void *object1, const void *object2, const ccd_t *search);
    static int penetration(const void *object1, const void *object2, const ccd_t *search, ccd_real_t *depth, ccd_vec3_t *direction,
                           ccd_vec3_t *position);

    // Limits this thread's tests during its lifetime.
    class Limit {
    public:
        Limit();
        ~Limit();
        Limit(const Limit &) = delete;
        Limit &operator=(const Limit &) = delete;

    private:
        const bool m_outer;
    };
};

// Upstream's ccd_convex_t, which is known in its file alone. It is that of the one release that the fork is made of
// (ode/releases/); every pair with a convex geom in the exactness suite depends on it.
struct dxCcdConvex {
    ccd_vec3_t position;
    ccd_quat_t rotation, inverseRotation;
    const dxConvex *convex;
};

// The support function of convex geoms: the point that is furthest along a direction.
//
// Like upstream's (ccdSupportConvex, ode/src/collision_libccd.cpp), it returns the first of the furthest points, by the
// same sums, but branch-free: which point is the furthest is unpredictable, and a pair of convex geoms makes dozens of
// calls. If the distance of every point is NaN, `support` keeps its value before it is rotated.
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
