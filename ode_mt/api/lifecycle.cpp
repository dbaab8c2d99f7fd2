// dInitODE2, dCloseODE and what belongs to them (ode/odeinit.h).
//
// Upstream's functions count calls in plain globals; here a mutex guards them, since any thread may
// initialise the library (contract C7). The last close ends the workers and frees their memory; so does
// unloading the library (contract C6).
#include <ode/odeinit.h>

#include <mutex>

#include "api/user_classes.h"
#include "collision/dxThreadTrimeshCache.h"
#include "dynamics/dxWorkingMemory.h"
#include "frame/dxStepRecords.h"
#include "frame/dxWorkers.h"

extern "C" {
// Upstream's own, renamed by the seam ode/seams/odeinit.h.
void dxUpstreamInitODE();
int dxUpstreamInitODE2(unsigned flags);
int dxUpstreamAllocateODEDataForThread(unsigned flags);
void dxUpstreamCleanupODEAllDataForThread();
void dxUpstreamCloseODE();
}

namespace {

struct Lifecycle {
    std::mutex mutex;
    unsigned initialisations = 0;
};

Lifecycle &lifecycle() {
    static Lifecycle *const instance = new Lifecycle;  // never destroyed: dCloseODE may come at exit
    return *instance;
}

void releaseWorkers() {
    dxWorkers::instance().stop();
    dxStepRecords::release();
    dxWorkingMemory::release();
    dxThreadTrimeshCache::release();
}

__attribute__((destructor)) void unload() { releaseWorkers(); }

}  // namespace

extern "C" {

void dInitODE() {
    std::lock_guard<std::mutex> lock(lifecycle().mutex);
    dxUpstreamInitODE();
    ++lifecycle().initialisations;
}

int dInitODE2(unsigned flags) {
    std::lock_guard<std::mutex> lock(lifecycle().mutex);
    const int done = dxUpstreamInitODE2(flags);
    if (done) ++lifecycle().initialisations;
    return done;
}

int dAllocateODEDataForThread(unsigned flags) {
    std::lock_guard<std::mutex> lock(lifecycle().mutex);
    return dxUpstreamAllocateODEDataForThread(flags);
}

void dCleanupODEAllDataForThread() {
    std::lock_guard<std::mutex> lock(lifecycle().mutex);
    dxUpstreamCleanupODEAllDataForThread();
}

void dCloseODE() {
    std::lock_guard<std::mutex> lock(lifecycle().mutex);
    dxUpstreamCloseODE();
    if (--lifecycle().initialisations == 0) {
        dxForgetUserClasses();
        releaseWorkers();
    }
}

}  // extern "C"
