// Two members of a space whose boxes overlap, in the order of the callback's arguments.
#pragma once

#include "collision/dxMembers.h"

struct dxOrderedPair {
    dxGeom *first, *second;
    dxMembers::Slot slots[2];
};

// Whether bodies and bits let two geoms meet: the tests of upstream's collideAABBs that do not depend on boxes.
bool dxMayMeet(const dxGeom *a, const dxGeom *b);
