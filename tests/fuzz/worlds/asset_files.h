// Small meshes and images of all kinds that a world may name.
#pragma once

#include <map>
#include <string>

namespace fuzz_worlds {

std::string objMesh();
std::string binaryStlMesh();
std::string greyImage();

// Returns the files by name: "shape.obj", "hills.png" ...
std::map<std::string, std::string> assetFiles();

bool isImage(const std::string &file);

}  // namespace fuzz_worlds
