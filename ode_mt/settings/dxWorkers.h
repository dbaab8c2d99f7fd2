// The process's thread manager. It is exchanged when the program names another, sets another number of threads (dToggleODE_MT), or has workers start
// in another way. dCloseODE ends its threads, and so does unloading. A manager starts threads only for runs that use them. While the program lends
// threads (dxThreadLender), they replace it.
//
// Process-wide, because threads are a property of the process: steps of several worlds at the same time
// use the same workers.
//
// Any of these functions may be called at any time, also by a callback that runs on a worker: none waits for a run in
// progress. A run keeps the manager that it began with; the last run of an exchanged manager ends its threads.
// So neither a run that never ends (a callback that ends the process, or waits for the caller) nor continuous runs
// block any other call.
//
// A worker's hook (dxWorkerHooks) runs outside of runs: a hook neither ends nor uses threads.
//
// Threading: any thread.
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
    std::string threadName();  // the beginning of the names of own threads that start from now on

    // From now on the threads are those of the lender; none: those of the manager that was chosen. Returns false if that is not possible, which is
    // reported with dMessage.
    bool lend(const dxThreadLender &lender);

    // Has workers that start from now on start with the options as change(options) changes them. `what` names the change in messages. Returns false
    // if that is not possible, which is reported with dMessage.
    bool changeOptions(const char *what, const std::function<void(dxWorkerOptions &)> &change);

    // Returns whether the calling thread may do what ends workers, such as setting another number of threads. In a hook it may not, which is reported
    // with dMessage.
    bool mayEndWorkers() const;

    // Ends all threads; those in use end with the last run. The next run starts new ones.
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
