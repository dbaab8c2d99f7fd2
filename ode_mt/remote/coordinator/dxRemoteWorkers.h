// The process's remote workers: the lock, the communication thread, and the turn to communicate.
//
// A step makes a batch (dxRemoteBatch), submits problems as they are made, and then asks for the next one until none is left.
//
//   dxRemoteScheduler      distributes problems to workers, and reclaims them
//   dxRemoteMessenger      messages to workers and from them
//   dxRemoteReplacement    new workers for lost ones
//
// The communication thread makes the transport, uses it and closes it; it sleeps while no step uses workers. Where the transport allows it,
// threads that step worlds communicate between islands (poll()), so that they need not wake that thread, which then looks for messages less often. A
// child of fork() has no remote workers; neither has a process after close().
//
// Threading: any thread; one lock, held for moments. Only open() waits for a worker. The thread that has the turn (m_isCommunicating) uses the
// transport, without the lock.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "remote/coordinator/dxRemoteReplacement.h"
#include "remote/transport/dxPollPause.h"
#include "threading/process/dxFork.h"
#include "threading/process/dxProcess.h"

class dxRemoteWorkers final : private dxForkListener {
public:
    static dxRemoteWorkers &instance();

    // Makes a transport, on the communication thread. Returns null if that is not possible: `reason` says why.
    using Open = std::function<std::unique_ptr<dxRemoteTransport>(std::string &reason)>;

    // Waits until the workers have been welcomed or refused, or for two seconds after the transport has been made. If making it takes longer than
    // `most`, there are no workers. Called once in a process, except in tests, which close in between.
    void open(const char *name, const dxRemoteHello &hello, Open open, std::chrono::nanoseconds most = kMaxToBegin);

    // Ends the communication thread, and the workers.
    void close();

    // The name of the communication thread, and of threads that it makes, as MPI does.
    static constexpr const char *kThreadName = "ode_mt-remote";

    // Called before open(). isOver() returns whether no threads of the program are left. It is called each second. If so, the process ends as it does
    // with its last thread, with status 0.
    using IsOver = std::function<bool()>;
    void endProcessWhen(IsOver isOver) { m_isOver = std::move(isOver); }

    // Returns whether there are any. Costs one load.
    bool areThere() const { return m_scheduler.areThere(); }

    dxRemoteCapacity capacity();

    // Wakes sleeping workers, as problems will come soon: they look for messages as often as they can.
    void wake();

    // Sends and receives messages between two islands, unless another thread does. If it is not urgent, only if no thread has for a while.
    void poll(bool isUrgent = false);

    using Counts = dxRemoteCounts;
    Counts counts();

private:
    friend class dxProcessObject<dxRemoteWorkers>;
    friend class dxRemoteBatch;

    static constexpr std::chrono::seconds kMaxToBegin{100};  // Open MPI itself gives up after 60

    dxRemoteWorkers() { listenToForks(); }
    ~dxRemoteWorkers() = default;
    void inForkedChild() override;
    void leaveAlone(dxRemoteLock &lock);

    // --- on the communication thread ------------------------------------------------------------------------
    void communicate();
    void begin();
    void awaitTurn(dxRemoteLock &lock);
    bool isPolled() const;
    void sleep(dxRemoteLock &lock);
    void sleepBetweenLooks(dxRemoteLock &lock);
    bool isProcessOver(dxRemoteLock &lock);
    void drain(dxRemoteLock &lock);
    void end();

    // --- on threads that step worlds, under the lock --------------------------------------------------------
    bool poll(dxRemoteLock &lock);
    void notify();
    bool lookForNews(dxRemoteLock &lock, const dxPollPause &pause);
    void waitForNews(dxRemoteLock &lock, dxPollPause &pause, double ns);

    dxForkSafeMutex m_mutex;
    dxRemoteScheduler m_scheduler;
    dxRemoteMessenger m_messenger{m_scheduler};
    dxRemoteReplacement m_replacement{m_scheduler, m_messenger};
    std::unique_ptr<dxRemoteTransport> m_transport;

    dxEventCount m_wake;   // of the communication thread
    dxEventCount m_turn;   // of the communication thread, while another one has it
    unsigned m_forks = 0;  // number of forks of which this process is the child
    bool m_isCommunicating = false, m_isTurnAwaited = false, m_isAsleep = false;
    std::atomic<bool> m_isForAllThreads{false};  // the transport
    std::atomic<double> m_polledAt{0};           // when a thread that steps a world last looked
    pthread_t m_thread{};
    bool m_isRunning = false, m_isClosing = false, m_hasBegun = false;

    std::string m_name;
    dxRemoteHello m_hello;
    Open m_open;
    IsOver m_isOver;
    double m_lastLook = 0;  // at that
    dxPollPause m_pause;
};
