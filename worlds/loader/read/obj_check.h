// Looks through a Wavefront OBJ file before it is imported: the importer takes what it cannot read for zero.
#pragma once

#include <cstddef>
#include <string>

namespace worlds {

// Cutting a polygon into triangles takes a time that grows with the square of its corners.
constexpr std::size_t maxCorners = 1000;

// Throws MeshFault for a vertex that is not three finite numbers or more, a face whose corners are no
// vertices of the file, and one with more than maxCorners.
void checkObj(const std::string &text);

}  // namespace worlds
