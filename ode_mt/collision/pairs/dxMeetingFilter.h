// What decides, beside boxes, whether two geoms may meet: the tests of upstream's collideAABBs that do not depend on
// boxes. A copy of a geom's fields, so that judging a pair does not touch the geoms.
#pragma once

#include <ode/common.h>

struct dxMeetingFilter {
    const dxBody *body = nullptr;
    unsigned long category = ~0ul, collide = ~0ul;
};

inline bool dxMayMeet(const dxMeetingFilter &a, const dxMeetingFilter &b) {
    if (a.body == b.body && a.body != nullptr) return false;
    return (a.category & b.collide) != 0 || (b.category & a.collide) != 0;
}
