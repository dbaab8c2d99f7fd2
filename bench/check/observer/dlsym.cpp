// dlsym, for programs that look ODE's functions up by name: what they get is the observer's.
#include <dlfcn.h>

#include <cstring>

#include "observed_calls.h"
#include "ode_library.h"

namespace observer {

namespace {

using Dlsym = void *(void *, const char *);

Dlsym *g_real = nullptr;  // every thread finds the same

// Versions of the symbol in the C libraries of Linux, the newest first.
Dlsym *findReal() {
    for (const char *const version : {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5"})
        if (void *const found = dlvsym(RTLD_NEXT, "dlsym", version)) return reinterpret_cast<Dlsym *>(found);
    return nullptr;
}

Dlsym *real() {
    if (g_real == nullptr) g_real = findReal();
    return g_real;
}

int indexOf(const char *name) {
    for (int i = 0; i < kCalls; ++i)
        if (std::strcmp(name, kCallNames[i]) == 0) return i;
    return -1;
}

void *lookUp(void *handle, const char *name, int index) {
    void *const found = real()(handle, name);
    if (found == nullptr) return nullptr;
    void *const observed = kObservedCalls[index];
    if (found != observed) return adoptLibraryOf(found).calls[index] == found ? observed : found;
    // Among all of the program the observer's comes first, which is nothing without the function behind it.
    return globalLibrary() != nullptr ? observed : nullptr;
}

}  // namespace

void *realDlsym(void *handle, const char *name) { return real()(handle, name); }

}  // namespace observer

// For RTLD_NEXT and RTLD_DEFAULT the C library looks at who calls it: those calls must be jumps, as optimising compilers make
// them of a call in the end (CMakeLists.txt).
extern "C" [[gnu::visibility("default")]] void *dlsym(void *handle, const char *name) {
    if (name[0] != 'd' || handle == RTLD_NEXT) return observer::real()(handle, name);
    const int index = observer::indexOf(name);
    if (index < 0) return observer::real()(handle, name);
    return observer::lookUp(handle, name, index);
}
