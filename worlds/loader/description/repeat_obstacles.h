// Gives a world more static shapes: its own obstacles once more, and once more, around it.
//
// The world's area is the smallest rectangle along x and y that holds all its static boxes, spheres,
// cylinders and capsules. Its obstacles are those shapes but for the outer walls, which touch the border
// and run along more than half of a side. Copies of the area, each with a copy of every obstacle, are
// laid around the area ring by ring, so that obstacles are as dense as before and outside of the
// walls: whatever moves within them moves as it did. The last copy may be incomplete; it takes obstacles
// in the order of the file.
#pragma once

#include "loader/description/world_description.h"

namespace worlds {

// Afterwards the world has `staticShapes` static shapes, planes and all. Throws LoadError at `place` when
// it has more already, or nothing to repeat.
void repeatObstacles(WorldDescription &world, std::size_t staticShapes, const Place &place);

}  // namespace worlds
