// Borrows threads of the user's: of a dThreadingImplementation that the user gave to a world or to the process, or of an executor
// (dxThreadLender).
//
// A thread is borrowed by posting a call. The call is not bound to a run: when a thread of the user's pool
// takes it up, it joins whatever run has seats, keeps looking for dxSpinTime after its last one, and goes
// back to the pool. A call taken up late finds nothing and returns.
//
//  - At most one posted call is waiting to be taken up, and calls are posted only while a run is in
//    progress: by its caller, or by a call that holds a block of it and finds that it can use more threads.
//    So nothing piles up in a pool that does not serve yet, and a pool that is shut down right after a run
//    may run the waiting call as its last one. (ODE's pool aborts on two, and on a call posted later.)
//  - run never waits for a posted call, only for blocks; wait_call is not used, so run may be called
//    from inside a threaded call.
//  - Calls refer to dxBorrowedThreads, which lives until the last of them has returned.
//
// workers() is the number of threads that serve an implementation, or that an executor is to lend (resize), for the caller takes the place of
// one of them: the user meant that many to be busy. With ODE's self-threaded implementation (0 threads)
// and with a pool of one, the caller works alone.
//
// One manager per implementation, kept from step to step: its threads go on looking for work for a moment,
// and two would make two waiting calls. In a forked child
// the user's threads are gone, so every run is done by its caller.
#pragma once

#include <ode/threading.h>

#include "threading/dxThreadManager.h"
#include "threading/pool/dxThreadLender.h"
#include "threading/process/dxFork.h"

class dxBorrowedThreads;

class dxThreadManagerUser final : public dxThreadManager, private dxForkListener {
public:
    // What lends must live until the manager is destroyed or stopped for good.
    dxThreadManagerUser(const dThreadingFunctionsInfo *functions, dThreadingImplementationID implementation);
    explicit dxThreadManagerUser(const dxThreadLender &lender, bool isServed = true);  // as dxBorrowedThreads
    ~dxThreadManagerUser() override;

    const char *name() const override { return "user"; }
    unsigned workers() const override;

    // An upper bound; the number of threads is the user's.
    void resize(unsigned workers) override;
    unsigned limit() const;
    void run(unsigned blocks, unsigned maxWorkers, Task task, void *context) override;

    // Waits until no thread of the user's is inside this library and no call is waiting; for at most a
    // second, since a pool that is not served never takes up the last one.
    void stop() override;

    // Whether no thread of the user's is inside and no call is waiting.
    bool idle() const;

private:
    void inForkedChild() override;

    dxBorrowedThreads *const borrowed;
};
