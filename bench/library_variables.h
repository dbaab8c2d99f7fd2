// The variables of the environment by which a user sets the library.
#pragma once

#include <string>
#include <vector>

namespace bench {

// Returns the names of all ODE_MT_... variables that are set, but for ODE_MT_WORLDS, which is the loader's.
// By their beginning, so that those of libraries to come are among them.
std::vector<std::string> libraryVariables();

}  // namespace bench
