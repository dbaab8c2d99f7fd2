// Messages to workers and from them: hellos, echoes, problems, results, signs of life. One thread at a time uses the transport:
// the one that has the turn (dxRemoteWorkers).
//
// Without memory it continues: problems that cannot be sent are reclaimed; a worker whose message cannot be read is dropped. Any other
// exception drops all workers.
//
// Threading: the thread that has the turn, under the lock of dxRemoteWorkers, which is free while the transport works; wakeAll() by any thread
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

    // `own`: what the hello of a worker must equal. `transport`: null: there is none.
    void begin(const dxRemoteHello &own, dxRemoteTransport *transport);

    // Sends and receives one message of each kind, if there is one. Returns whether there was any.
    bool exchange(dxRemoteLock &lock);

    // Receives one message. Throws what the transport throws.
    bool receive(dxRemoteLock &lock);

    // Has sleeping workers woken, as problems will come soon.
    void wakeAll() { m_isWaking = true; }

    bool hasSomethingToSay() const { return m_scheduler.hasQueued() || m_scheduler.hasWithdrawals() || m_isWaking; }

    // Has a worker end. One that does not get the message ends when it has received nothing for a while. `isOrderly`: all end.
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
