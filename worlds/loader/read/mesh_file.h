// Triangles out of a mesh file, STL, OBJ or COLLADA: looked through here, then imported by Assimp, which takes what it cannot read for zero,
// and makes do with facets that are not triangles.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "loader/description/world_description.h"
#include "loader/load_error.h"
#include "support/text.h"

namespace worlds {

// What is wrong with the inside of a mesh file, in words; readMeshFile adds which file it is.
class MeshFault : public std::runtime_error {
public:
    explicit MeshFault(const std::string &what) : std::runtime_error(support::printable(what)) {}
};

// Cutting a polygon into triangles takes a time that grows with the square of its corners.
constexpr std::size_t maxCorners = 1000;

// `place` is where the mesh is named. Throws LoadError.
TriangleMesh readMeshFile(const std::string &file, const Vector3 &scale, const Place &place);

}  // namespace worlds
