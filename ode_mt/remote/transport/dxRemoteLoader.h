// Loads the library of a transport, libode_mt_NAME.so: from the folder of this library, as in the build's, or ode_mt/ in it, as installed, else where
// the system's loader finds it. So libode.so.8 is linked to no MPI, and a process without remote workers loads none.
#pragma once

#include <memory>
#include <string>

#include "remote/transport/dxRemoteTransport.h"

// `wanted`: workers to start; 0: those that are there. Null: `reason` says why. The library stays loaded.
std::unique_ptr<dxRemoteTransport> dxLoadRemoteTransport(const char *name, unsigned wanted, std::string &reason);
