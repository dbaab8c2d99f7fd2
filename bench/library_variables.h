// The variables of the environment by which a user sets the library.
#pragma once

#include <string>
#include <vector>

namespace bench {

// Returns the names of all ODE_MT_... variables that are set, but for ODE_MT_WORLDS, which is the loader's.
// Variables are recognised by their prefix, so that those of later versions are included.
std::vector<std::string> libraryVariables();

}  // namespace bench
