// Hilly ground as a triangle mesh or as a height field, from the same heights.
#pragma once

#include "scenes/world_scene.h"

namespace scenes {

class Terrain {
public:
    // A square of at least `width` metres with one corner at the origin, sampled every `pitch` metres.
    explicit Terrain(dReal width, dReal pitch = 1);

    static constexpr dReal kSteepest = REAL(0.41);  // slope
    static dReal height(dReal x, dReal y);          // m, not above 0.6 nor below -0.6

    dReal width() const { return m_pitch * m_cells; }  // m

    dGeomID addMesh(WorldScene &scene) const;
    dGeomID addHeightField(WorldScene &scene) const;

private:
    dReal m_pitch;
    int m_cells;  // along each side
};

}  // namespace scenes
