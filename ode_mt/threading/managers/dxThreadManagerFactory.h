// Thread managers by name, as ODE_MT_THREAD_MANAGER gives it. The manager of a user's threading
// implementation is not made here: it needs the implementation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "threading/dxThreadManager.h"
#include "threading/pool/dxWorkerThread.h"

namespace dxThreadManagerFactory {

// The one that measured better; see docs/threading.md.
const char *defaultName();

// All managers; for one of them the system may lack a library.
std::vector<const char *> names();

// File name of a library that this manager needs and the dynamic loader does not find; null if there is none. Loads it.
const char *missingLibrary(const std::string &name);

// Whether its threads are started as dxWorkerOptions say. Those of a runtime are not the library's to start.
bool takesOptions(const std::string &name);

// Null for a name that is not in names() and where a library is missing; the reason is logged.
std::unique_ptr<dxThreadManager> create(const std::string &name, const dxWorkerOptions &options = {});

}  // namespace dxThreadManagerFactory
