// Boxes for tests.
#pragma once

#include <limits>

#include "core/dxBounds.h"

constexpr dReal kInfinite = std::numeric_limits<dReal>::infinity();
constexpr dReal kNaN = std::numeric_limits<dReal>::quiet_NaN();

inline dxBounds boundsOf(dReal lowX, dReal highX, dReal lowY, dReal highY, dReal lowZ, dReal highZ) {
    const dReal aabb[6] = {lowX, highX, lowY, highY, lowZ, highZ};
    return dxBounds(aabb);
}

inline dxBounds cubeAt(dReal x, dReal y, dReal z, dReal edge = 1) {
    const dReal half = edge / 2;
    return boundsOf(x - half, x + half, y - half, y + half, z - half, z + half);
}
