// What is said to workers, and what they say: greetings, echoes, problems, results, signs of life. It uses the transport, one thread at a time:
// the one that has the turn (dxRemoteWorkers).
//
// Memory: whatever is refused, it goes on. Problems that cannot be sent are reclaimed; a worker whose message cannot be read is dropped. What
// else is thrown drops all workers.
//
// Threading: by whoever has the turn, under the lock of dxRemoteWorkers, which is free while the transport is at work; wakeAll() by any thread
// under the lock.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "remote/coordinator/dxRemoteScheduler.h"
#include "remote/transport/dxRemoteFrame.h"
#include "remote/transport/dxRemoteTransport.h"
#include "remote/transport/dxSpareBytes.h"
#include "threading/process/dxFork.h"

using dxRemoteLock = std::unique_lock<dxForkSafeMutex>;

class dxRemoteMessenger {
public:
    explicit dxRemoteMessenger(dxRemoteScheduler &scheduler) : m_scheduler(scheduler) {}

    // `own`: what workers have to be like. `transport`: null: there is none.
    void begin(const dxRemoteHello &own, dxRemoteTransport *transport);

    // Sends and receives one message of each kind, if there is one. Returns whether there was any.
    bool exchange(dxRemoteLock &lock);

    // Receives one message. Throws what the transport throws.
    bool receive(dxRemoteLock &lock);

    // Tells workers that sleep that problems are about to come.
    void wakeAll() { m_isWaking = true; }

    bool hasSomethingToSay() const { return m_scheduler.hasQueued() || m_scheduler.hasWithdrawals() || m_isWaking; }

    // A worker that cannot be told ends when it has not heard of this process for a while. `isOrderly`: all end.
    void sendQuit(unsigned worker, bool isOrderly, dxRemoteLock &lock);

private:
    bool send(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock);
    void sendIfMemory(unsigned worker, dxRemoteKind kind, std::uint64_t number, dxRemoteLock &lock);
    bool sendProblems(dxRemoteLock &lock);
    void sendHeartbeat(dxRemoteLock &lock);
    bool sendWithdrawals(dxRemoteLock &lock);
    bool sendWakeUps(dxRemoteLock &lock);
    void sendEcho(unsigned worker, dxRemoteLock &lock);

    void handle(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock);
    void handleHello(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock);
    void handleEcho(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock);

    dxRemoteWorker &at(unsigned worker) { return m_scheduler.workers()[worker]; }

    dxRemoteScheduler &m_scheduler;
    dxRemoteTransport *m_transport = nullptr;
    dxRemoteHello m_own;
    bool m_isWaking = false;
    double m_lastAlive = 0;
    dxSpareBytes m_spare;
    dxRemoteBytes m_received;
};
