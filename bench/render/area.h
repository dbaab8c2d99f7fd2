// A rectangle on the camera's screen.
#pragma once

#include "render/camera.h"

#include <vector>

namespace render {

struct Area {
    double left = 0, right = 0, top = 0, bottom = 0;  // m on the screen

    void include(const Point &point);
    bool overlaps(const Area &o) const {
        return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
    }
};

// Requires at least one point.
Area areaOf(const std::vector<Point> &points);

}  // namespace render
