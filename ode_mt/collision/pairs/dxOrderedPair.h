// Two members of a space whose boxes overlap, in the order of the callback's arguments.
#pragma once

#include "collision/pairs/dxMembers.h"

struct dxOrderedPair {
    dxGeom *first, *second;
    dxMembers::Slot slots[2];
};
