// Which geoms are height fields, and the data that they were given. For files that look into upstream's geoms.
#pragma once

#include <ode/ode.h>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "heightfield.h"

inline bool dxIsHeightField(const dxGeom &geom) { return geom.type == dHeightfieldClass; }

// Requires a height field. The program may have destroyed the data (dxLiveHeightfields).
inline const dxHeightfieldData *dxHeightsOf(const dxGeom &geom) {
    return static_cast<const dxHeightfield &>(geom).m_p_data;
}
