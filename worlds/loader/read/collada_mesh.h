// The polygons of a COLLADA <mesh>, with every number and reference checked: Assimp does not check them.
#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <string>
#include <vector>

namespace worlds {

struct ColladaMesh {
    std::string positions;  // x y z of each vertex, as they were written
    std::size_t vertexCount = 0;
    std::vector<std::size_t> sizes;      // corners of each polygon
    std::vector<std::uint32_t> corners;  // of all of them, as numbers of vertices
};

// Points and lines are skipped. Throws MeshFault.
ColladaMesh readColladaMesh(const tinyxml2::XMLElement &mesh);

// For readers of COLLADA. All of them throw MeshFault.
std::string shownElement(const tinyxml2::XMLElement &element);
[[noreturn]] void fail(const tinyxml2::XMLElement &element, const std::string &what);
const tinyxml2::XMLElement &requiredChild(const tinyxml2::XMLElement &element, const char *name);
// A whole number that is not negative.
std::size_t countOf(const tinyxml2::XMLElement &element, const char *attribute);
std::size_t countOf(const tinyxml2::XMLElement &element, const char *attribute, std::size_t otherwise);
// The id that an attribute names as "#id".
std::string referenceOf(const tinyxml2::XMLElement &element, const char *attribute);

}  // namespace worlds
