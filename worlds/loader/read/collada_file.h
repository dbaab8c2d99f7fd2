// A COLLADA file made safe to import.
#pragma once

#include <string>

namespace worlds {

// The text of a COLLADA file that holds what `text` shows of triangles and polygons, and nothing else: no
// materials, no animations; instances of nodes are expanded. Every number, reference and
// count was checked: Assimp reads beyond arrays, and follows a node that contains itself endlessly. Throws
// MeshFault.
std::string reduceCollada(const std::string &text);

}  // namespace worlds
