// Counter of changes to inputs of colliders without a notification of the space: samples of a height field, destroyed
// data of meshes or height fields, or the position of a body, which some functions of joints change and restore with
// rounding.
//
// Prefetched contacts are invalid if the callback, or an earlier one, has made such a change (dxNarrowphasePrefetch).
#pragma once

#include "core/dxEventCounter.h"

extern dxEventCounter dxSilentChanges;
