// Workers of the OpenMP runtime (dxOpenMPRuntime.h): one parallel region per run.
//
// Limits that come from the runtime, which owns its threads:
//  - The caller waits for every thread of the region, also for one that took no block and is not
//    scheduled.
//  - The runtime keeps a pool per calling thread. To bound their number, one run at a time has a region;
//    a run that begins meanwhile, nested ones included, is done by its caller alone.
//  - stop ends the pool of the thread that calls it. The pool of another thread ends with that thread.
//  - libgomp ends the process when the system refuses a thread. Before a region is larger than any before,
//    as many threads are started and ended again on trial; what is refused there is not asked of it.
//  - A region with another number of threads than the last one may end or start threads.
//  - After fork the child can use regions, unless the fork happened inside one: then it runs alone.
//
// Threading: as dxThreadManager.
#pragma once

#include <atomic>
#include <memory>

#include "threading/dxThreadManager.h"
#include "threading/managers/dxOpenMPRuntime.h"
#include "threading/pool/dxWorkerThread.h"
#include "threading/process/dxFork.h"

class dxThreadManagerOpenMP final : public dxThreadManager, private dxForkListener {
public:
    explicit dxThreadManagerOpenMP(const dxOpenMPRuntime &runtime, dxCreateThread create = pthread_create);
    ~dxThreadManagerOpenMP() override;

    // Loads the runtime; null where it is not installed.
    static std::unique_ptr<dxThreadManager> make(dxCreateThread create = pthread_create);

    const char *name() const override { return "openmp"; }
    unsigned workers() const override { return m_size.load(); }
    void resize(unsigned workers) override;
    void run(unsigned blocks, unsigned maxWorkers, Task task, void *context) override;
    void stop() override;

private:
    void beforeFork() override;
    void inForkedChild() override;

    unsigned allowedTeam(unsigned wanted);

    const dxOpenMPRuntime m_runtime;
    const dxCreateThread m_create;
    std::atomic<unsigned> m_size{1};               // workers wanted, the caller included
    std::atomic<unsigned> m_allowed{kMaxWorkers};  // workers the system gives, the caller included
    std::atomic<bool> m_isBusy{false};             // some run has a region
    bool m_areRegionsSafeInChild = true;
    bool m_isAlone = false;     // in a child where a region could hang
    bool m_isReported = false;  // a refusal
};
