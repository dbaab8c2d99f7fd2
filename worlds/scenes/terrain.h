// Hilly ground as a triangle mesh or as a height field, from the same heights.
#pragma once

#include "scenes/world_scene.h"

namespace scenes {

class Terrain {
public:
    // A square of `width` metres with one corner at the origin, sampled every kPitch metres.
    explicit Terrain(dReal width);

    static constexpr dReal kPitch = 1;  // m

    static dReal height(dReal x, dReal y);  // m

    dGeomID addMesh(WorldScene &scene) const;
    dGeomID addHeightField(WorldScene &scene) const;

private:
    int m_cells;  // along each side
};

}  // namespace scenes
