#include "ode_library.h"

#include <dlfcn.h>

#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace observer {

const char *const kCallNames[kCalls] = {"dWorldCreate", "dWorldDestroy", "dBodyCreate",
                                        "dBodyDestroy", "dWorldStep",    "dWorldQuickStep"};

namespace {

constexpr const char *kGetter = "dBodyGetPosition";  // which nobody has a reason to stand in front of

std::atomic<const OdeLibrary *> g_library{nullptr};
std::mutex g_mutex;

template <class Function>
void find(void *handle, const char *name, Function *&function) {
    function = reinterpret_cast<Function *>(realDlsym(handle, name));
}

// Lives as long as the process: what uses it may run in destructors of the program.
const OdeLibrary *open(void *getter) {
    Dl_info info{};
    if (getter == nullptr || dladdr(getter, &info) == 0) return nullptr;
    void *const handle = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return nullptr;
    auto *const library = new OdeLibrary;
    char path[PATH_MAX];
    library->file = realpath(info.dli_fname, path) != nullptr ? path : info.dli_fname;
    library->isOurs = realDlsym(handle, "dToggleODE_MT") != nullptr;
    for (int i = 0; i < kCalls; ++i) {
        void *const next = realDlsym(RTLD_NEXT, kCallNames[i]);  // may be another observer's
        library->calls[i] = next != nullptr ? next : realDlsym(handle, kCallNames[i]);
    }
    int (*checkConfiguration)(const char *) = nullptr;
    find(handle, "dCheckConfiguration", checkConfiguration);
    library->isDouble = checkConfiguration != nullptr && checkConfiguration("ODE_double_precision") != 0;
    find(handle, "dBodyGetWorld", library->bodyGetWorld);
    find(handle, kGetter, library->bodyGetPosition);
    find(handle, "dBodyGetQuaternion", library->bodyGetQuaternion);
    find(handle, "dBodyGetLinearVel", library->bodyGetLinearVel);
    find(handle, "dBodyGetAngularVel", library->bodyGetAngularVel);
    find(handle, "dBodyGetForce", library->bodyGetForce);
    find(handle, "dBodyGetTorque", library->bodyGetTorque);
    find(handle, "dBodyIsEnabled", library->bodyIsEnabled);
    return library;
}

const OdeLibrary *keep(void *(*findGetter)(const void *), const void *argument) {
    if (const OdeLibrary *const known = g_library.load(std::memory_order_acquire)) return known;
    const std::lock_guard<std::mutex> lock(g_mutex);
    if (const OdeLibrary *const known = g_library.load(std::memory_order_relaxed)) return known;
    const OdeLibrary *const found = open(findGetter(argument));
    g_library.store(found, std::memory_order_release);
    return found;
}

void *globalGetter(const void *) { return realDlsym(RTLD_NEXT, kGetter); }

// As seen from the object that an address is in: that of a module which was loaded for itself alone, with its libraries.
void *getterSeenFrom(const void *address) {
    if (void *const global = globalGetter(nullptr)) return global;
    Dl_info info{};
    if (dladdr(address, &info) == 0) return nullptr;
    void *const handle = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return nullptr;
    void *const getter = realDlsym(handle, kGetter);
    dlclose(handle);
    return getter;
}

}  // namespace

const OdeLibrary &libraryOf(const void *caller) {
    const OdeLibrary *const library = keep(getterSeenFrom, caller);
    if (library == nullptr) {
        std::fputs("odemt_check: a function of ODE is called, and no library that defines it can be found\n", stderr);
        std::abort();
    }
    return *library;
}

const OdeLibrary &adoptLibraryOf(void *function) { return libraryOf(function); }

const OdeLibrary *globalLibrary() { return keep(globalGetter, nullptr); }

}  // namespace observer
