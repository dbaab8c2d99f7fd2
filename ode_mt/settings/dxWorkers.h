// The process's thread manager: exchanged by name, by dToggleODE_MT, and where workers are to start in another way; its threads ended by
// dCloseODE and when the library is unloaded. A manager starts threads only for runs that use them. Threads of the program's own take its
// place while they are lent (dxThreadLender).
//
// Process-wide, because threads are a property of the process: steps of several worlds at the same time
// use the same workers.
//
// Any of these functions may be called at any time, also by a callback that runs on a worker: none waits for a run in
// progress. A run keeps the manager that it began with; the run that leaves an exchanged manager last ends its threads.
// So neither a run that never ends (a callback that ends the process, or waits for the caller) nor continuous runs
// block any other call.
//
// A worker's hook (dxWorkerHooks) runs outside of runs: in it threads are neither ended nor used.
//
// Dropped: a shared lock for runs and an exclusive one for changes. A change inside a callback deadlocked, and so did
// the end of the process.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "threading/dxThreadManager.h"
#include "threading/managers/dxThreadManagerUser.h"
#include "threading/pool/dxWorkerThread.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

class dxWorkers {
public:
    static dxWorkers &instance();

    void run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

    // Makes the pool as large as dxSettings and dxOwnThreads say, for runs from now on.
    void resize();

    bool choose(const std::string &name);  // false: not possible, reported with dMessage
    const char *name();
    std::string threadName();  // with which those of its own threads' names begin that start from now on

    // From now on the threads are those of the lender; none: those of the manager that was chosen. Returns false if that is not possible, which is
    // reported with dMessage.
    bool lend(const dxThreadLender &lender);

    // Workers that start from now on start with what change(options) leaves, for which `what` stands in messages. False: not
    // possible, reported with dMessage.
    bool changeOptions(const char *what, const std::function<void(dxWorkerOptions &)> &change);

    // Whether the calling thread may set another number of threads, or whatever else ends workers: not in a hook, which is reported with dMessage.
    bool mayEndWorkers() const;

    // Ends all threads, those that are in use with the last run; the next run starts new ones.
    void stop();

private:
    friend class dxProcessObject<dxWorkers>;
    using Manager = std::shared_ptr<dxThreadManager>;

    dxWorkers();
    ~dxWorkers() = default;

    Manager current();
    Manager makeCurrent();
    bool hasOptions();
    void exchange(const std::function<void()> &change);

    dxForkSafeMutex m_mutex;  // guards what follows, for moments: managers are made and ended without it
    Manager m_manager;        // null until the next run needs one, and while threads are lent
    const char *m_name;
    dxThreadLender m_lender;
    dxWorkerOptions m_options;
    std::atomic<unsigned> m_choice{0};  // counts changes of the above
};
