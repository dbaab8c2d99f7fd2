// Functions of ode/odeinit.h.
//
// Upstream's functions count calls in plain globals; here a mutex guards them, since any thread may
// initialise the library (contract C7). The last close ends the workers and frees their memory; so does
// unloading the library (contract C6).
#include <ode/odeinit.h>

#include <atomic>
#include <mutex>

#include "collision/callbacks/dxConcurrentCallbacks.h"
#include "collision/narrowphase/dxColliderTable.h"
#include "collision/narrowphase/dxThreadTrimeshCache.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/quick_step/sor/dxParallelSor.h"
#include "dynamics/step/dxJointRemoval.h"
#include "dynamics/step/dxStepRecords.h"
#include "dynamics/step/islands/dxLargeIslandWorkers.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/fast/dxFastWorldStep.h"
#include "remote/dxRemote.h"
#include "seams/upstream.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorldStatistics.h"
#include "threading/process/dxForkLocks.h"
#include "threading/timeline/dxTimeline.h"

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

void releaseWorkers() {
    dxWorkers::instance().stop();
    dxForgetConcurrentCallbacks();
    dxForgetJointRemoval();
    dxStepRecords::release();
    dxFastWorldStep::release();
    dxFastQuickStepState::release();
    dxLargeIslandWorkersLease::forget();
    dxParallelSor::forget();
    dxWorkingMemory::release();
}

__attribute__((destructor)) void unload() {
    dxRemote::close();
    releaseWorkers();
    dxThreadTrimeshCache::unload();
    dxWorldStatistics::unload();
    dxTimeline::unload();
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
        dxColliderTable::forgetClasses();
        dxThreadTrimeshCache::release();
        releaseWorkers();
        dxTimeline::flushAtClose();
    }
}

}  // extern "C"
