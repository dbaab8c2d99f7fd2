// The process's remote workers: the lock, the communication thread, and whose turn it is to communicate.
//
// A step makes a batch (dxRemoteBatch), submits problems as they are made, and then asks what is next until nothing is left.
//
//   dxRemoteScheduler      which problem goes to which worker, and what happens to it
//   dxRemoteMessenger      what is said to workers, and what they say
//   dxRemoteReplacement    workers in the place of lost ones
//
// The communication thread makes the transport, uses it and closes it; it sleeps while nothing is under way. Where the transport allows it,
// threads that step worlds do in between what that thread would have to be woken for (poll()), and it looks less often. A child of fork() has no
// remote workers; neither has a process after close().
//
// Threading: any thread; one lock, held for moments. Never waits for a worker but in open(). The transport is used without the lock, by whoever has
// the turn (m_isCommunicating).
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

    // Makes a transport on the communication thread; null: `reason` says why not.
    using Open = std::function<std::unique_ptr<dxRemoteTransport>(std::string &reason)>;

    // Waits until the workers have been welcomed or refused, or for two seconds after the transport has been made; there are none if that takes more
    // than `most`. Once in a process, but for tests, which close in between.
    void open(const char *name, const dxRemoteHello &hello, Open open, std::chrono::nanoseconds most = kMaxToBegin);

    // Ends the communication thread, and the workers.
    void close();

    // Of threads that the communication thread makes, as MPI does, and its own.
    static constexpr const char *kThreadName = "ode_mt-remote";

    // Before open(): tells whether no threads of the program's are left. It is asked each second; the process ends then as it does with its last
    // thread, with status 0.
    using IsOver = std::function<bool()>;
    void endProcessWhen(IsOver isOver) { m_isOver = std::move(isOver); }

    // Whether there are any, at the cost of one look.
    bool areThere() const { return m_scheduler.areThere(); }

    dxRemoteCapacity capacity();

    // Problems are about to come: workers that sleep look for them again as often as they can.
    void wake();

    // Between two islands: sends and receives what there is, if nobody else does, and, unless it is urgent, nobody has for a while.
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
    unsigned m_forks = 0;  // of which this process is the child
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
