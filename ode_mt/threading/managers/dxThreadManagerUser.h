// Threads that the program lends: those of a dThreadingImplementation that it gave to a world or to the process, or of an executor
// (dODE_MT_SetExecutor).
//
// A thread is lent by posting a call. The call is not bound to a run: when a thread of the program's takes it, it joins any run that has seats, keeps
// looking for kSpinTime after its last one, and returns to the program. A call that is made late finds nothing and returns.
//
//  - At most one posted call is waiting to be made, and calls are posted only while a run is in progress: by its caller, or by a call that holds a
//    block of it and finds that it can use more threads. So calls do not pile up in a pool that does not serve yet, and a pool that is shut down
//    right after a run may make the waiting call as its last one. (ODE's pool aborts on two, and on a call posted later.)
//  - run never waits for a posted call, only for blocks; wait_call is not used, so run may be called from inside a threaded call.
//  - Calls refer to a state of their own, which lives until the last of them has returned.
//
// workers() is the number of threads that serve an implementation, or that an executor is to lend (resize). It counts the caller, which takes the
// place of one of them, as the program meant that many threads to be busy. With ODE's self-threaded implementation (0 threads) and with a pool of
// one, the caller works alone.
//
// There is one manager per lender, kept from step to step: its threads go on looking for work for a moment, and two would make two waiting calls. In
// a forked child the program's threads do not exist, so every run is done by its caller.
//
// Threading: any thread, also from inside a task.
#pragma once

#include <ode/threading.h>

#include "threading/dxThreadManager.h"
#include "threading/process/dxFork.h"

// Who lends the threads: a threading implementation of ODE's, or an executor.
struct dxThreadLender {
    using Work = void (*)(void *data);
    using Executor = void (*)(void *context, Work work, void *data);

    bool isNone() const { return functions == nullptr && executor == nullptr; }

    bool operator==(const dxThreadLender &other) const {
        return functions == other.functions && implementation == other.implementation && executor == other.executor &&
               context == other.context;
    }

    // Returns how many threads serve the implementation; kMaxWorkers for an executor, which does not tell.
    unsigned threads() const;

    // Makes room for calls that wait, of which there is one at most.
    void prepare() const;

    // Has a thread call call(data, ...) or work(data), depending on the kind of lender.
    void post(dThreadedCallFunction *call, Work work, void *data) const;

    const dThreadingFunctionsInfo *functions = nullptr;
    dThreadingImplementationID implementation = nullptr;

    Executor executor = nullptr;
    void *context = nullptr;
};

class dxThreadManagerUser final : public dxThreadManager, private dxForkListener {
public:
    // The lender must live until the manager is destroyed or stopped for good.
    dxThreadManagerUser(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation);
    // `isServed`: false in a child of fork if the lender was lent before the fork. Every run is then done by its caller.
    explicit dxThreadManagerUser(const dxThreadLender &lender, bool isServed = true);
    ~dxThreadManagerUser() override;

    const char *name() const override { return "user"; }
    unsigned workers() const override;

    // Sets an upper bound; the number of threads is the program's.
    void resize(unsigned workers) override;
    unsigned limit() const;
    void run(unsigned blocks, unsigned maxWorkers, Task task, void *context) override;

    // Waits until no thread of the program's is inside this library and no call is waiting; for at most a second, since a pool that does not serve
    // never makes the last one.
    void stop() override;

    // Returns whether no thread of the program's is inside and no call is waiting.
    bool idle() const;

private:
    class Calls;

    void inForkedChild() override;

    Calls *const m_calls;
};
