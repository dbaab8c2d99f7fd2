// Thread managers by name, as ODE_MT_THREAD_MANAGER gives it. The manager of threads that the program lends (dxThreadManagerUser) is not made here:
// it needs the lender.
//
// Threading: any thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "threading/dxThreadManager.h"
#include "threading/pool/dxWorkerThread.h"

namespace dxThreadManagerFactory {

// The one that measured better; see docs/threading.md.
const char *defaultName();

// Returns all managers; for one of them the system may lack a library.
std::vector<const char *> names();

// The same as a text, with commas, for messages.
std::string knownNames();

// Loads the library that this manager needs. Returns its file name if the dynamic loader does not find it, else null.
const char *missingLibrary(const std::string &name);

// Returns whether its threads are started as dxWorkerOptions say. A runtime starts its own.
bool takesOptions(const std::string &name);

// Returns null for a name that is not in names() and where a library is missing, and logs the reason.
std::unique_ptr<dxThreadManager> create(const std::string &name, const dxWorkerOptions &options = {});

}  // namespace dxThreadManagerFactory
