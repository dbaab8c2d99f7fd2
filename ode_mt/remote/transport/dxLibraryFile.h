// Which file a library was loaded from.
//
// Threading: any thread.
#pragma once

#include <dlfcn.h>

#include <cstdlib>
#include <memory>
#include <string>

// `address`: of a function of the library. Without symbolic links: /lib may be one to /usr/lib, and odemt_top and odemt_check give programs a folder
// with a link to the library alone. Empty: it is not known.
inline std::string dxFindLibraryFile(void *address) {
    Dl_info info;
    if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) return "";
    const std::unique_ptr<char, decltype(&std::free)> path(realpath(info.dli_fname, nullptr), &std::free);
    return path != nullptr ? path.get() : info.dli_fname;
}
