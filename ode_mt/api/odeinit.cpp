// Functions of ode/odeinit.h.
//
// Upstream's functions count calls in plain globals; here a mutex guards them, since any thread may
// initialise the library (contract C7). The last close ends the workers and frees their memory; so does
// unloading the library (contract C6).
#include <ode/odeinit.h>

#include <atomic>
#include <mutex>

#include "collision/narrowphase/dxColliderTable.h"
#include "remote/dxRemote.h"
#include "seams/upstream.h"
#include "settings/dxWorkers.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

namespace {

std::atomic<unsigned> initialisations{0};  // written under dxForkLocks::initialisation

// The lock of a call that needs an initialised library. Without one upstream is about to report an error, to
// a handler of the user that may never return, so nothing is locked.
std::unique_lock<std::recursive_mutex> lockIfInitialised() {
    if (initialisations == 0) return {};
    return std::unique_lock<std::recursive_mutex>(dxForkLocks::initialisation);
}

void countInitialisation() {
    if (++initialisations == 1) dxColliderTable::forget();
}

__attribute__((destructor)) void unload() {
    dxRemote::close();
    dxWorkers::instance().stop();
    dxProcess::unload();
}

}  // namespace

extern "C" {

// MPI may fork on the communication thread, which takes the lock: remote workers are waited for without it.
void dInitODE() {
    {
        const std::lock_guard<std::recursive_mutex> lock(dxForkLocks::initialisation);
        dxUpstreamInitODE();
        countInitialisation();
    }
    dxRemote::open();
}

int dInitODE2(unsigned flags) {
    {
        const std::lock_guard<std::recursive_mutex> lock(dxForkLocks::initialisation);
        if (!dxUpstreamInitODE2(flags)) return 0;
        countInitialisation();
    }
    dxRemote::open();
    return 1;
}

int dAllocateODEDataForThread(unsigned flags) {
    const std::unique_lock<std::recursive_mutex> lock = lockIfInitialised();
    return dxUpstreamAllocateODEDataForThread(flags);
}

void dCleanupODEAllDataForThread() {
    const std::unique_lock<std::recursive_mutex> lock = lockIfInitialised();
    dxUpstreamCleanupODEAllDataForThread();
}

// A worker's hook may want the lock while it is waited for: the workers end before it is taken.
void dCloseODE() {
    if (initialisations == 1) dxWorkers::instance().stop();
    const std::unique_lock<std::recursive_mutex> lock = lockIfInitialised();
    dxUpstreamCloseODE();
    if (--initialisations == 0) {
        dxWorkers::instance().stop();
        dxProcess::close();
    }
}

}  // extern "C"
