#include "threading/managers/dxOpenMPRuntime.h"

#include <dlfcn.h>
#include <pthread.h>

#include "core/dxGuards.h"
#include "threading/process/dxProcess.h"

namespace {

template <class Function>
bool find(void *library, const char *name, Function *&function) {
    function = reinterpret_cast<Function *>(dlsym(library, name));
    return function != nullptr;
}

#ifdef __clang__
constexpr bool kIsGnu = false;
#else
constexpr bool kIsGnu = true;
#endif

// Unloading a library that uses libgomp ends its threads, by pthread_exit, under the dynamic loader's lock. The first pthread_exit of a process takes
// that lock to load the unwinder, so it is called before.
struct LoadedUnwinder {
    LoadedUnwinder() {
        const dxNoCancellation whole;
        pthread_t thread;
        const auto body = [](void *) -> void * { pthread_exit(nullptr); };
        if (pthread_create(&thread, nullptr, body, nullptr) == 0) pthread_join(thread, nullptr);
    }
};

dxProcessObject<LoadedUnwinder> unwinder;

}  // namespace

const char *dxOpenMPRuntime::fileName() { return kIsGnu ? "libgomp.so.1" : "libomp.so.5"; }

// The loader counts a library that is loaded already.
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

void dxOpenMPRuntime::prepareRegions() const {
    if (kIsGnu)
        *unwinder;
    else if (m_setBlockTime != nullptr)
        m_setBlockTime(0);
}

bool dxOpenMPRuntime::endThreads() const {
    constexpr int kPauseHard = 2;  // omp_pause_hard of OpenMP 5.0
    if (!kIsGnu) return false;
    const dxNoCancellation whole;
    return m_pauseAll(kPauseHard) == 0;
}

bool dxOpenMPRuntime::prepareFork() const { return kIsGnu ? endThreads() : m_inParallel() == 0; }
