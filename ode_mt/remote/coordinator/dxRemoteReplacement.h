// Replaces lost workers by new ones, one at a time, where the transport can.
//
// Threading: the thread that made the transport, when it has the turn, under the lock of dxRemoteWorkers.
#pragma once

#include "remote/coordinator/dxRemoteMessenger.h"

class dxRemoteReplacement {
public:
    dxRemoteReplacement(dxRemoteScheduler &scheduler, dxRemoteMessenger &messenger) : m_scheduler(scheduler), m_messenger(messenger) {}

    // `transport`: null: there is none.
    void begin(dxRemoteTransport *transport);

    // Drops workers that have not answered for seconds, and goes on with replacements. Returns whether there is news.
    bool advance(dxRemoteLock &lock);

    // Takes the worker that is being started, if it has started or cannot. Returns whether none is being started any more.
    bool takeStarted();

    bool isStarting() const { return m_isStarting; }

    // Returns whether a worker is lost that will be replaced.
    bool isNeeded() const;

private:
    bool start(double now, dxRemoteLock &lock);

    dxRemoteScheduler &m_scheduler;
    dxRemoteMessenger &m_messenger;
    dxRemoteTransport *m_transport = nullptr;
    bool m_canReplace = false, m_isStarting = false;
    unsigned m_worker = 0;  // that is being started
};
