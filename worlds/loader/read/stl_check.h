// Looks through an STL file before it is imported: the importer makes do with facets that are not triangles.
#pragma once

#include <string>

namespace worlds {

// Throws MeshFault for a file that is neither binary, with room for exactly the triangles that it says it
// holds, nor text, with every facet a triangle of finite numbers and every solid ended.
void checkStl(const std::string &bytes);

}  // namespace worlds
