// What is wrong with the inside of a mesh file, in words; mesh_file.h adds which file it is.
#pragma once

#include "loader/load_error.h"

#include <stdexcept>
#include <string>

namespace worlds {

class MeshFault : public std::runtime_error {
public:
    explicit MeshFault(const std::string &what) : std::runtime_error(printable(what)) {}
};

}  // namespace worlds
