// Height fields: which geoms are, the data that they were given, and which data objects still exist. For files that look into upstream's geoms.
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

// The existing data objects of height fields.
//
// A program may destroy such data while geoms have it, if it does not collide them any more: upstream then does not
// access it. Code that examines pairs before their callbacks must check here first. Threading: any thread.
namespace dxLiveHeightfields {

// Without memory for the entry, the data counts as destroyed.
void add(const dxHeightfieldData *data);
void remove(const dxHeightfieldData *data);
bool has(const dxHeightfieldData *data);

}  // namespace dxLiveHeightfields
