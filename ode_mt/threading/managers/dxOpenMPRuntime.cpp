#include "threading/managers/dxOpenMPRuntime.h"

#include <dlfcn.h>

namespace {

template <class Function>
bool find(void *library, const char *name, Function *&function) {
    function = reinterpret_cast<Function *>(dlsym(library, name));
    return function != nullptr;
}

}  // namespace

// The loader counts a library that is there already.
std::optional<dxOpenMPRuntime> dxOpenMPRuntime::load() {
    void *const library = dlopen(fileName(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) return std::nullopt;
    dxOpenMPRuntime runtime;
    find(library, "kmp_set_blocktime", runtime.m_setBlockTime);
    const bool isWhole = find(library, "GOMP_parallel", runtime.m_parallel) && find(library, "omp_get_thread_num", runtime.m_threadNumber) &&
                         find(library, "omp_in_parallel", runtime.m_inParallel) &&
                         find(library, "omp_pause_resource_all", runtime.m_pauseAll);
    return isWhole ? std::optional(runtime) : std::nullopt;
}
