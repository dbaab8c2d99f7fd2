#include "remote/coordinator/dxRemoteMessenger.h"

#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "core/dxGuards.h"
#include "core/dxLog.h"

namespace {

// Returns why a worker with this hello is refused; empty: it is welcome.
std::string findHelloFault(const dxRemoteHello &worker, const dxRemoteHello &own) {
    if (std::strcmp(worker.version, own.version) != 0) return "is version " + std::string(worker.version) + " of ODE_MT, not " + own.version;
    if (worker.realSize != own.realSize)
        return "computes with numbers of " + std::to_string(worker.realSize) + " bytes, not " + std::to_string(own.realSize);
    if (worker.digest != own.digest) return "computes other bits for the problems of the self-test";
    return "";
}

}  // namespace

void dxRemoteMessenger::begin(const dxRemoteHello &own, dxRemoteTransport *transport) {
    m_own = own;
    m_transport = transport;
    m_isWaking = false;
}

bool dxRemoteMessenger::exchange(dxRemoteLock &lock) try {
    const bool hasWoken = sendWakeUps(lock), hasWithdrawn = sendWithdrawals(lock);
    sendHeartbeat(lock);
    const bool hasSent = sendProblems(lock), hasReceived = receive(lock);
    return hasWoken || hasWithdrawn || hasSent || hasReceived;
} catch (const std::exception &fault) {
    m_scheduler.dropAll(fault.what());
    return false;
} catch (...) {
    m_scheduler.dropAll("an exception");
    return false;
}

// --- messages to workers ------------------------------------------------------------------------------------

bool dxRemoteMessenger::send(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock) {
    bool isSent = false;
    {
        const dxUnlocked others(lock);
        isSent = m_transport->send(worker, message.data(), message.size());
    }
    if (!isSent) m_scheduler.dropUnreachable(worker, "cannot be reached");
    if (static_cast<dxRemoteKind>(dxReadHeader(message).kind) != dxRemoteKind::Alive) at(worker).link.noteContact(m_scheduler.now());
    return isSent;
}

// Without memory for the message it is not sent.
void dxRemoteMessenger::sendIfMemory(unsigned worker, dxRemoteKind kind, std::uint64_t number, dxRemoteLock &lock) try {
    send(worker, dxRemoteFrame().seal(kind, number), lock);
} catch (const std::bad_alloc &) {
    m_scheduler.warnOfMemory();
}

bool dxRemoteMessenger::sendProblems(dxRemoteLock &lock) {
    dxRemoteSending sending;
    if (!m_scheduler.takeMessage(sending)) return false;
    if (sending.problems.empty()) return true;
    bool isSent = false;
    try {
        dxRemoteFrame frame(m_spare.take());
        {
            const dxUnlocked others(lock);
            for (std::size_t i = 0; i < sending.problems.size(); ++i)
                frame.addItem(sending.problems[i], sending.bytes[i].data(), sending.bytes[i].size());
            const dxRemoteBytes &message = frame.seal(dxRemoteKind::Problems, sending.number);
            isSent = m_transport->send(sending.worker, message.data(), message.size());
        }
        m_spare.giveBack(frame.release());
        for (dxRemoteBytes &bytes : sending.bytes) m_scheduler.giveSpareBack(std::move(bytes));
    } catch (const std::bad_alloc &) {
        m_scheduler.takeMessageBack(sending);
        return true;
    }
    if (!isSent) m_scheduler.dropUnreachable(sending.worker, "cannot be reached");
    return true;
}

void dxRemoteMessenger::sendHeartbeat(dxRemoteLock &lock) {
    constexpr double kHeartbeatNs = 5e9;
    const double time = m_scheduler.now();
    if (time - m_lastAlive <= kHeartbeatNs) return;
    m_lastAlive = time;
    for (unsigned i = 0; i < m_scheduler.workers().size(); ++i) {
        // A lost worker needs no sign of life if it will be replaced.
        const bool isHeard = at(i).isOpen() ? !at(i).link.isLate() : at(i).isLost() && !m_transport->canReplace();
        if (isHeard && !at(i).isUnreachable) sendIfMemory(i, dxRemoteKind::Alive, 0, lock);
    }
}

// Without memory for the message the worker solves problems that are no longer wanted.
bool dxRemoteMessenger::sendWithdrawals(dxRemoteLock &lock) {
    if (!m_scheduler.hasWithdrawals()) return false;
    m_scheduler.noteWithdrawalsSent();
    for (unsigned i = 0; i < m_scheduler.workers().size(); ++i) {
        for (std::uint64_t number = 0; at(i).link.takeWithdrawal(number);) {
            if (at(i).isOpen()) sendIfMemory(i, dxRemoteKind::Withdraw, number, lock);
        }
    }
    return true;
}

// Without memory for the message the worker goes on sleeping.
bool dxRemoteMessenger::sendWakeUps(dxRemoteLock &lock) {
    if (!std::exchange(m_isWaking, false)) return false;
    for (unsigned i = 0; i < m_scheduler.workers().size(); ++i) {
        const double time = m_scheduler.now();
        if (at(i).link.isUsable(time) && at(i).link.isAsleep(time)) sendIfMemory(i, dxRemoteKind::Wake, 0, lock);
    }
    return true;
}

void dxRemoteMessenger::sendEcho(unsigned worker, dxRemoteLock &lock) {
    dxRemoteFrame echo(m_spare.take());
    dxLinkMeasurement &measurement = at(worker).measurement;
    const dxRemoteBytes content(measurement.size());
    echo.add(content.data(), content.size());
    const dxRemoteBytes &message = echo.seal(dxRemoteKind::Echo, measurement.number());
    measurement.begin(m_scheduler.now());
    send(worker, message, lock);
    m_spare.giveBack(echo.release());
}

void dxRemoteMessenger::sendQuit(unsigned worker, bool isOrderly, dxRemoteLock &lock) {
    const std::byte body{isOrderly};
    try {
        dxRemoteFrame quit;
        quit.add(&body, 1);
        send(worker, quit.seal(dxRemoteKind::Quit), lock);
    } catch (...) {
        m_scheduler.dropWorker(worker, "cannot be told to end");
    }
}

// --- messages from workers ----------------------------------------------------------------------------------

bool dxRemoteMessenger::receive(dxRemoteLock &lock) {
    if (m_transport == nullptr) return false;
    unsigned worker = 0;
    std::size_t bytes = 0;
    bool isReceived = false;
    const char *fault = nullptr;
    try {
        {
            const dxUnlocked others(lock);
            bytes = m_transport->waiting(worker);
            if (m_received.capacity() > dxSpareBytes::kMaxCapacity) dxRemoteBytes().swap(m_received);
            m_received.resize(bytes);
            isReceived = bytes != 0 && m_transport->receive(m_received.data());
            fault = isReceived ? dxFindFrameFault(m_received) : nullptr;
        }
        if (bytes == 0 || worker >= m_scheduler.workers().size()) return false;
        if (at(worker).isLost()) return true;  // is not read
        if (!isReceived)
            m_scheduler.dropUnreachable(worker, "is disconnected");
        else if (fault != nullptr)
            m_scheduler.dropWorker(worker, "sent a message that is ", fault);
        else
            handle(worker, m_received, lock);
    } catch (const std::bad_alloc &) {
        if (bytes == 0 || worker >= m_scheduler.workers().size()) throw;
        m_scheduler.dropWorker(worker, "sent a message for which there is no memory");
    }
    return true;
}

void dxRemoteMessenger::handle(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock) {
    switch (static_cast<dxRemoteKind>(dxReadHeader(message).kind)) {
        case dxRemoteKind::Hello: return handleHello(worker, message, lock);
        case dxRemoteKind::Echo: return handleEcho(worker, message, lock);
        case dxRemoteKind::Results: return m_scheduler.accept(worker, message);
        default: return m_scheduler.dropWorker(worker, "sent a message that a worker has no reason to send");
    }
}

void dxRemoteMessenger::handleHello(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock) {
    dxRemoteHello hello;
    if (message.size() != sizeof(dxRemoteHeader) + sizeof hello) return m_scheduler.dropWorker(worker, "sent a hello of another size");
    std::memcpy(&hello, message.data() + sizeof(dxRemoteHeader), sizeof hello);
    hello.version[sizeof hello.version - 1] = '\0';
    const std::string why = findHelloFault(hello, m_own);
    if (!why.empty()) {
        at(worker).isRefused = true;
        dxRemoteFrame refusal;
        refusal.add(why.data(), why.size());
        send(worker, refusal.seal(dxRemoteKind::Refusal), lock);
        return m_scheduler.dropWorker(worker, "", why.c_str());
    }
    at(worker).link.welcome();
    if (send(worker, dxRemoteFrame().seal(dxRemoteKind::Welcome), lock)) sendEcho(worker, lock);
}

void dxRemoteMessenger::handleEcho(unsigned worker, const dxRemoteBytes &message, dxRemoteLock &lock) {
    dxRemoteWorker &one = at(worker);
    const double time = m_scheduler.now();
    const bool isMeasured = one.link.state() == dxRemoteLink::State::Measured;
    const auto echo = isMeasured ? one.measurement.end(dxReadHeader(message).number, time) : dxLinkMeasurement::Echo::Unexpected;
    if (echo == dxLinkMeasurement::Echo::Unexpected) return m_scheduler.dropWorker(worker, "sent an echo of nothing");
    one.link.noteAwake(time);
    if (echo == dxLinkMeasurement::Echo::Next) return sendEcho(worker, lock);
    one.link.setMeasured(one.measurement.latencyNs(), one.measurement.nsPerByte());
    if (one.isReplacement)
        dxLog(dxLogLevel::Info, "remote worker %u is replaced; latency %.0f us, %.2f GB/s", worker + 1, one.measurement.latencyNs() / 1e3,
              1 / one.link.nsPerByte());
    m_scheduler.noteAvailable();
    m_scheduler.news().notify();
}
