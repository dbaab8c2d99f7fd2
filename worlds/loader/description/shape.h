// Collision shapes, SI units, each in its own frame with z up.
#pragma once

#include "loader/description/geometry.h"

#include <cstdint>
#include <variant>
#include <vector>

namespace worlds {

struct Box {
    Vector3 size;
};
struct Sphere {
    double radius;
};
struct Cylinder {  // along z
    double radius, length;
};
struct Capsule {  // along z; the length goes without the caps
    double radius, length;
};
struct Plane {
    Vector3 normal;
};
struct TriangleMesh {
    std::vector<float> vertices;           // x y z of each
    std::vector<std::uint32_t> triangles;  // three vertex numbers each
};
struct HeightField {
    int columns = 0, rows = 0;    // samples along x and y, at least 2 each
    std::vector<double> heights;  // row by row, the first row at the largest y
    double width = 0, depth = 0;  // between the first and last sample along x and y
};

using Shape = std::variant<Box, Sphere, Cylinder, Capsule, Plane, TriangleMesh, HeightField>;

}  // namespace worlds
