// The tests of upstream's collideAABBs that do not depend on boxes. It is a copy of a geom's fields, so that testing a
// pair causes no cache miss on the geoms.
#pragma once

#include <ode/common.h>

struct dxPairFilter {
    const dxBody *body = nullptr;
    unsigned long category = ~0ul, collide = ~0ul;

    // Whether it may exclude a geom whose filter may exclude none.
    bool mayExclude() const { return body != nullptr || (category & collide) != ~0ul; }
};

// Without branches, which would be mispredicted where about half of the pairs are excluded.
inline bool dxFiltersAgree(const dxPairFilter &a, const dxPairFilter &b) {
    const bool haveOneBody = (a.body == b.body) & (a.body != nullptr);
    return !haveOneBody & (((a.category & b.collide) | (b.category & a.collide)) != 0);
}
