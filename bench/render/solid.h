// A geom as something that can be drawn: a box around it, by which solids are put in order, and the convex
// patches that a camera sees of it.
#pragma once

#include "render/camera.h"

#include <vector>

namespace render {

struct OrientedBox {
    Vector centre{};
    std::array<Vector, 3> axes{};  // of length 1
    Vector half{};                 // along the axes

    std::vector<Vector> corners() const;
};

struct Patch {
    std::vector<Point> corners;
    double light = 1;  // 0 to 1
};

// A geom of any kind but "plane".
OrientedBox boxAround(const record::Shape &shape, const record::Pose &pose);

// Returns the patches from the back to the front.
std::vector<Patch> patchesOf(const record::Shape &shape, const record::Pose &pose, const Camera &camera);

}  // namespace render
