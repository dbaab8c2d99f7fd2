// The tests of upstream's collideAABBs that do not depend on boxes. It is a copy of a geom's fields, so that testing a
// pair causes no cache miss on the geoms.
#pragma once

#include <ode/common.h>

struct dxPairFilter {
    const dxBody *body = nullptr;
    unsigned long category = ~0ul, collide = ~0ul;
};

inline bool dxFiltersAgree(const dxPairFilter &a, const dxPairFilter &b) {
    if (a.body == b.body && a.body != nullptr) return false;
    return (a.category & b.collide) != 0 || (b.category & a.collide) != 0;
}
