// The smallest convex polygon around points: Andrew's monotone chain (1979).
#pragma once

#include "render/camera.h"

#include <vector>

namespace render {

std::vector<Point> convexHull(std::vector<Point> points);

}  // namespace render
