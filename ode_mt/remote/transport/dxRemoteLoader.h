// Loads the library of a transport, libode_mt_NAME.so: from the folder of this library, as in the build's, or from ode_mt/ in it, as installed, else
// from where the system's loader finds it. So libode.so.8 is linked to no MPI, and a process without remote workers loads none.
//
// Threading: any thread.
#pragma once

#include <dlfcn.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "remote/transport/dxRemoteTransport.h"

// Returns the file from which a library was loaded, without symbolic links: /lib may be one to /usr/lib, and odemt_top and odemt_check give programs
// a folder with a link to the library alone. `address`: of a function of the library. Empty: not known.
inline std::string dxFindLibraryFile(void *address) {
    Dl_info info;
    if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) return "";
    const std::unique_ptr<char, decltype(&std::free)> path(realpath(info.dli_fname, nullptr), &std::free);
    return path != nullptr ? path.get() : info.dli_fname;
}

// `wanted`: number of workers to start; 0: those that there are. Returns null if it cannot be loaded: `reason` says why. The library stays loaded.
std::unique_ptr<dxRemoteTransport> dxLoadRemoteTransport(const char *name, unsigned wanted, std::string &reason);
