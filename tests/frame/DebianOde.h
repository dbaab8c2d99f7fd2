// Debian's own libode.so.8, the oracle, loaded beside the library under test.
//
// The tests are linked with the static library and export none of its symbols, so each of the two calls
// itself only.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <ode/common.h>

namespace debianOde {

// Debian's dReal is double. Functions that take or give one can be compared in a build of that precision
// only.
constexpr bool kSamePrecision = sizeof(dReal) == sizeof(double);

inline void *library() {
    static void *const handle = dlopen(ODE_MT_DEBIAN_ODE, RTLD_NOW | RTLD_LOCAL);
    return handle;
}

// The function of that name, with the type of the one under test: debianOde::function(dRand, "dRand").
template <class Function>
Function *function(Function *, const char *name) {
    void *const found = library() ? dlsym(library(), name) : nullptr;
    if (found == nullptr) ADD_FAILURE() << "no " << name << " in " << ODE_MT_DEBIAN_ODE;
    return reinterpret_cast<Function *>(found);
}

}  // namespace debianOde
