// Triangles out of a mesh file, STL, OBJ or COLLADA: looked through here, then imported by Assimp.
#pragma once

#include "loader/description/shape.h"
#include "loader/load_error.h"

#include <ignition/math/Vector3.hh>

#include <string>

namespace worlds {

// `place` is where the mesh is named. Throws LoadError.
TriangleMesh readMeshFile(const std::string &file, const ignition::math::Vector3d &scale, const Place &place);

}  // namespace worlds
