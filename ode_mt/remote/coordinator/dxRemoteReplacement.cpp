#include "remote/coordinator/dxRemoteReplacement.h"

#include <algorithm>

#include "core/dxLog.h"

void dxRemoteReplacement::begin(dxRemoteTransport *transport) {
    m_transport = transport;
    m_canReplace = transport != nullptr && transport->canReplace();
    m_isStarting = false;
}

bool dxRemoteReplacement::advance(dxRemoteLock &lock) {
    constexpr double kHelloNs = 10e9;  // a new worker that is not usable after this time is lost
    if (!m_canReplace) return false;
    const double time = m_scheduler.now();
    for (unsigned i = 0; i < m_scheduler.workers().size(); ++i) {
        const dxRemoteWorker &one = m_scheduler.workers()[i];
        if (one.link.isGone(time)) m_scheduler.dropWorker(i, "has not answered for seconds");
        if (!one.isSettled() && time - one.since > kHelloNs) m_scheduler.dropWorker(i, "has not said what it is");
    }
    return m_isStarting ? takeStarted() : start(time, lock);
}

bool dxRemoteReplacement::takeStarted() {
    const dxRemoteTransport::Replacement replacement = m_transport->replacement();
    if (replacement == dxRemoteTransport::Replacement::Expected) return false;
    m_isStarting = false;
    dxRemoteWorker &one = m_scheduler.workers()[m_worker];
    if (replacement == dxRemoteTransport::Replacement::Failed) {
        dxLog(dxLogLevel::Warning, "remote worker %u cannot be replaced", m_worker + 1);
        one.restart.begin(m_scheduler.now(), false);
        m_canReplace = m_transport->canReplace();
        return true;
    }
    ++m_scheduler.counters().replaced;
    one.becomeReplacement(m_scheduler.now());
    return true;
}

// The lost worker may be alive.
bool dxRemoteReplacement::start(double now, dxRemoteLock &lock) {
    std::vector<dxRemoteWorker> &workers = m_scheduler.workers();
    const auto isDue = [now](const dxRemoteWorker &one) { return one.isReplaceable() && one.restart.isOver(now); };
    const auto found = std::find_if(workers.begin(), workers.end(), isDue);
    if (found == workers.end()) return false;
    m_worker = static_cast<unsigned>(found - workers.begin());
    m_isStarting = true;
    m_messenger.sendQuit(m_worker, false, lock);
    m_transport->replace(m_worker);
    return true;
}

bool dxRemoteReplacement::isNeeded() const {
    return m_canReplace && m_scheduler.any([](const dxRemoteWorker &one) { return one.isReplaceable(); });
}
