// libgomp (gcc).
//
// Idle threads: after a region a thread spins for 300,000 pauses (about 7 ms at 2.6 GHz), then sleeps;
// with more threads than processors it spins for 1000. Only the environment, read when the process
// starts, changes that (OMP_WAIT_POLICY=passive), so there is nothing to do per run.
//
// Fork: the child inherits a pool whose threads are gone and hangs in its next region. Without a pool
// at the time of the fork the child makes one of its own.
//
// Unloading: the threads of another user thread's pool sleep in libgomp until that thread ends, so it is kept in memory from
// the first region on. When a library that uses them is unloaded they are ended under the dynamic loader's lock; and the
// first pthread_exit of a process, which is how they end, wants that lock to load the unwinder. So the first one happens before.
#include <omp.h>
#include <pthread.h>

#include "core/dxNoCancellation.h"
#include "threading/managers/dxOpenMPRuntime.h"
#include "threading/process/dxPinnedLibrary.h"
#include "threading/process/dxProcessObject.h"

namespace {

struct PreparedRuntime {
    PreparedRuntime() {
        dxPinLibraryOf(&omp_get_thread_num);
        loadUnwinder();
    }

    static void loadUnwinder() {
        const dxNoCancellation whole;
        pthread_t thread;
        const auto body = [](void *) -> void * { pthread_exit(nullptr); };
        if (pthread_create(&thread, nullptr, body, nullptr) == 0) pthread_join(thread, nullptr);
    }
};

dxProcessObject<PreparedRuntime> runtime;

}  // namespace

void dxOpenMPPrepareRegions() { *runtime; }

bool dxOpenMPEndThreads() {
    const dxNoCancellation whole;
    return omp_pause_resource_all(omp_pause_hard) == 0;
}

bool dxOpenMPPrepareFork() { return dxOpenMPEndThreads(); }
