// A library that stays in memory until the process ends, because threads that sleep in its code may outlive whoever uses it.
#pragma once

#include <dlfcn.h>

// The one that has `function`. Where the loader refuses, it is unloaded like any other.
template <class Function>
void dxPinLibraryOf(Function *function) {
    Dl_info library;
    if (dladdr(reinterpret_cast<void *>(function), &library) != 0)
        dlopen(library.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
}
