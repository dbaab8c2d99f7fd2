// In which order solids are drawn so that what is in front covers what is behind it.
//
// Two boxes that a face of one of them parts are in order by that face, wherever they are; this is what
// sorting by distance gets wrong for a long wall and something small beside it (Newell, Newell and Sancha
// 1972, their third and fourth tests). Boxes that reach into one another, and cycles, go by distance.
#pragma once

#include "render/solid.h"

#include <vector>

namespace render {

// Places in `boxes`, the first to be drawn first.
std::vector<std::size_t> painterOrder(const std::vector<OrientedBox> &boxes, const Camera &camera);

}  // namespace render
