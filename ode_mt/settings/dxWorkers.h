// The process's thread manager: exchanged by name and by dToggleODE_MT, its threads ended by dCloseODE and when the
// library is unloaded. A manager starts threads only for runs that use them.
//
// Process-wide, because threads are a property of the process: steps of several worlds at the same time
// borrow the same workers.
//
// Any of these functions may be called at any time, also by a callback that runs on a worker: none waits for a run in
// progress. A run keeps the manager that it began with; the run that leaves an exchanged manager last ends its threads.
// So neither a run that never ends (a callback that ends the process, or waits for the caller) nor continuous runs
// block any other call.
//
// Dropped: a shared lock for runs and an exclusive one for changes. A change inside a callback deadlocked, and so did
// the end of the process.
#pragma once

#include <memory>
#include <string>

#include "threading/dxThreadManager.h"
#include "threading/process/dxForkLocks.h"
#include "threading/process/dxProcessObject.h"

class dxWorkers {
public:
    static dxWorkers &instance();

    void run(unsigned blocks, unsigned workers, dxThreadManager::Task task, void *context);

    // Makes the pool as large as dxSettings says, for runs from now on.
    void resize();

    bool choose(const std::string &name);  // false: unknown, reported with dMessage
    const char *name();

    // Ends all threads, those that are in use with the last run; the next run starts new ones.
    void stop();

private:
    friend class dxProcessObject<dxWorkers>;
    using Manager = std::shared_ptr<dxThreadManager>;

    dxWorkers();
    ~dxWorkers() = default;

    Manager current();

    dxForkSafeMutex m_mutex;  // guards what follows, for moments: managers are made and ended without it
    Manager m_manager;        // null until the next run needs one
    const char *m_name;
};
