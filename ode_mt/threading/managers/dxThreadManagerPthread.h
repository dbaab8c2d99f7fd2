// A pool of POSIX threads.
//
// Life of a worker:
//
//        created ──> searching ──joins a run──> at work ──no block left──> searching
//                     │   ^                                                  │
//     dxAdaptiveSpin  │   │ woken by a run that can use it                   │ stop
//       without work  v   │                                                  v
//                     parked (asleep)                                        ends
//
// Threads are started by runs that can use more workers than are idle, not by resize. Waking, joining
// and leaving a run take no lock; locks guard only the start and end of threads.
//
// Threading rule: run, from any thread and also from inside a task; resize and stop, from any thread but
// not from inside a task. A run during a stop is done by its caller alone.
//
// After fork the child starts with no workers and gets its own on its first run. A child forked from
// inside a task can only exec or exit: the blocks of that run are lost with the threads that held them.
//
// A process whose main thread ends by pthread_exit, without dCloseODE, ends with its last other thread: within a second
// of that the workers end, too (dxProcessThreads.h).
//
// Dropped: a mutex and a condition variable around a list of jobs (a waiter per run queued on the
// mutex at every join and leave); C++ thread_local with destructors (pins the library in memory).
#pragma once

#include <atomic>
#include <mutex>

#include "threading/pool/dxJobBoard.h"
#include "threading/pool/dxParking.h"
#include "threading/pool/dxWorkerThread.h"
#include "threading/process/dxFork.h"

class dxThreadManagerPthread final : public dxThreadManager, private dxForkListener, private dxWorkerSource {
public:
    explicit dxThreadManagerPthread(dxCreateThread create = pthread_create, const dxWorkerOptions &options = {});
    ~dxThreadManagerPthread() override;

    const char *name() const override { return "pthread"; }
    unsigned workers() const override { return m_size.load(); }
    void resize(unsigned workers) override;
    void run(unsigned blocks, unsigned maxWorkers, Task task, void *context) override;
    void stop() override;

private:
    void inForkedChild() override;
    void requestWorkers(unsigned wanted) override;

    bool mayStartThread() const;
    bool startThread();
    void joinThreads();
    void setStopping(bool value);

    static void *threadBody(void *manager);
    void becomeWorker(unsigned number);
    void serve();
    void workUntilIdle(dxAdaptiveSpin &spin);
    bool shouldStayAwake();
    void endWithTheProcess();
    void passOnWakeUp();

    const dxCreateThread m_create;
    const dxWorkerOptions m_options;
    dxJobBoard m_board;
    dxParking m_parking;
    std::atomic<bool> m_isStopping{false};
    std::atomic<unsigned> m_size{1};                // workers wanted, the caller included
    std::atomic<unsigned> m_allowed{kMaxWorkers};   // workers the system gives, the caller included
    std::atomic<unsigned> m_started{0};
    std::atomic<unsigned> m_numbered{0};            // threads that have taken their number
    bool m_isReported = false;                      // a refusal
    std::mutex m_lifecycle;  // held by stop and resize
    std::mutex m_creation;   // held while one thread is started; never while one is waited for
    pthread_t m_threads[kMaxWorkers - 1];
};
