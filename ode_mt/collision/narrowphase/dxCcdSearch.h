// libccd's search for the overlap of two shapes, which may be left.
//
// It asks for a furthest point in each turn, and where numbers are too large to tell one turn from the next it goes on without end. A
// callback that collides such a pair never returns, with upstream's library as with ours. But contacts ahead of callbacks
// (dxContactsAhead) are looked for without being asked: under a limit of turns, the search is left by a dxUpstreamInterrupted.
#pragma once

#include <ccd/ccd.h>

class dxCcdSearch {
public:
    // As libccd's functions of these names; under the thread's limit, if it has one.
    static int intersect(const void *object1, const void *object2, const ccd_t *search);
    static int penetration(const void *object1, const void *object2, const ccd_t *search, ccd_real_t *depth, ccd_vec3_t *direction,
                           ccd_vec3_t *position);

    // Limits this thread's searches for as long as it exists.
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
