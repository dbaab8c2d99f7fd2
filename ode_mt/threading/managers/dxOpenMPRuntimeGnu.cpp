// libgomp (gcc).
//
// Idle threads: after a region a thread spins for 300,000 pauses (about 7 ms at 2.6 GHz), then sleeps;
// with more threads than processors it spins for 1000. Only the environment, read when the runtime is
// loaded, changes that (OMP_WAIT_POLICY=passive), so there is nothing to do per run.
//
// Fork: the child inherits a pool whose threads are gone and hangs in its next region. Without a pool
// at the time of the fork the child makes one of its own.
//
// Unloading: when a library that uses its threads is unloaded they are ended under the dynamic loader's lock; and the
// first pthread_exit of a process, which is how they end, wants that lock to load the unwinder. So the first one happens before.
#include <pthread.h>

#include "core/dxGuards.h"
#include "threading/managers/dxOpenMPRuntime.h"
#include "threading/process/dxProcess.h"

namespace {

constexpr int kPauseHard = 2;  // omp_pause_hard of OpenMP 5.0

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

const char *dxOpenMPRuntime::fileName() { return "libgomp.so.1"; }

void dxOpenMPRuntime::prepareRegions() const { *unwinder; }

bool dxOpenMPRuntime::endThreads() const {
    const dxNoCancellation whole;
    return m_pauseAll(kPauseHard) == 0;
}

bool dxOpenMPRuntime::prepareFork() const { return endThreads(); }
