// libccd's iterative overlap test of two shapes (Minkowski portal refinement: Snethen, "XenoCollide", Game Programming Gems 7, 2008),
// with a limit of iterations.
//
// Each iteration calls the support functions; where numbers are too large for progress, the iteration never ends. A
// callback that collides such a pair never returns, with upstream's library as with ours. But the narrow-phase prefetch
// (dxNarrowphasePrefetch) computes contacts that may never be asked for: there the iteration is left at the limit, by a
// dxUpstreamInterrupted.
#pragma once

#include <ccd/ccd.h>

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
