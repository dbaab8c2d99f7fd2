// Thread managers by name, as ODE_MT_THREAD_MANAGER gives it. The manager of a user's threading
// implementation is not made here: it needs the implementation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "threading/dxThreadManager.h"

namespace dxThreadManagerFactory {

// The one that measured better; see docs/thread-managers.md.
const char *defaultName();

// The managers of this build. "openmp" is missing where CMake found no OpenMP.
std::vector<const char *> names();

// Null for a name that is not in names(); the reason is logged.
std::unique_ptr<dxThreadManager> create(const std::string &name);

}  // namespace dxThreadManagerFactory
