// Triangles out of a mesh file, STL, OBJ or COLLADA: looked through here, then imported by Assimp.
#pragma once

#include "loader/description/world_description.h"
#include "loader/load_error.h"

#include <string>

namespace worlds {

// `place` is where the mesh is named. Throws LoadError.
TriangleMesh readMeshFile(const std::string &file, const Vector3 &scale, const Place &place);

}  // namespace worlds
