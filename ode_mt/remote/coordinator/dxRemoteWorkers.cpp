#include "remote/coordinator/dxRemoteWorkers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "remote/coordinator/dxRemoteSchedule.h"
#include "threading/pool/dxWorkerThread.h"

namespace {

// While an echo is awaited the communication thread keeps its core, so that a worker on the same core is moved to another one, as soon as the
// scheduler of the system looks (4 ms).
constexpr std::chrono::milliseconds kEchoMoment{20};

constexpr double kOverLookNs = 1e9;       // between two looks at whether the program's threads have ended
constexpr double kSettleNs = 2e9;         // how long open() waits for workers
constexpr double kRestartPollNs = 20e6;   // between two looks at whether a worker has started
constexpr double kMaxStartNs = 3e9;       // how long close() waits for a worker that is being started
constexpr double kDrainNs = 1e9;          // how long close() waits for unneeded results, so that all workers can end in good order
constexpr double kPolledNs = 400e3;       // the communication thread does not look if another one has within this time
constexpr double kMaxAtOnceNs = 100e3;    // after which another thread stops looking, even if there is more to do
// Between two looks of the communication thread while other threads may look: it uses a core that they need.
constexpr double kMaxBesideOthersNs = 2e6;

dxProcessObject<dxRemoteWorkers> remoteWorkers;

std::chrono::nanoseconds duration(double ns) { return std::chrono::nanoseconds(static_cast<std::int64_t>(ns)); }

}  // namespace

dxRemoteWorkers &dxRemoteWorkers::instance() { return *remoteWorkers; }

void dxRemoteWorkers::open(const char *name, const dxRemoteHello &hello, Open open, std::chrono::nanoseconds most) {
    const dxNoCancellation whole;
    dxRemoteLock lock(m_mutex);
    if (m_isRunning) return;
    m_name = name;
    m_hello = hello;
    m_open = std::move(open);
    m_isClosing = m_hasBegun = m_isCommunicating = m_isTurnAwaited = m_isAsleep = false;
    m_isForAllThreads = false;
    m_scheduler.forgetQueue();  // in a child of fork() it has the problems of the parent's threads
    const auto body = [](void *self) -> void * {
        static_cast<dxRemoteWorkers *>(self)->communicate();
        return nullptr;
    };
    const int error = dxStartThread(pthread_create, m_thread, body, this, dxWorkerOptions());
    if (error != 0) {
        dxLog(dxLogLevel::Warning, "remote workers: no thread to communicate (error %d); islands stay in this process", error);
        return;
    }
    if (!m_scheduler.news().waitFor(lock, most, [this] { return m_hasBegun; })) return leaveAlone(lock);
    m_isRunning = true;
    const auto isSettled = [](const dxRemoteWorker &one) { return one.isSettled(); };
    m_scheduler.news().waitFor(lock, duration(kSettleNs), [&] { return m_scheduler.all(isSettled); });
    const std::size_t wanted = m_scheduler.workers().size();
    if (wanted == 0) return;
    lock.unlock();
    const dxRemoteCapacity all = capacity();
    dxLog(all.workers == 0 ? dxLogLevel::Warning : dxLogLevel::Info,
          "remote workers: %u of %zu by %s; latency %.0f us, %.2f GB/s", all.workers, wanted, name, all.latencyNs / 1e3,
          all.nsPerByte > 0 ? 1 / all.nsPerByte : 0);
}

// The transport may wait for ever, for a worker that ended before it could join. If it does get its workers, the thread closes it.
void dxRemoteWorkers::leaveAlone(dxRemoteLock &lock) {
    m_isClosing = true;
    pthread_detach(m_thread);
    lock.unlock();
    dxLog(dxLogLevel::Warning, "remote workers: none by %s: it does not begin; islands stay in this process", m_name.c_str());
}

void dxRemoteWorkers::close() {
    const dxNoCancellation whole;
    {
        const dxRemoteLock lock(m_mutex);
        if (!m_isRunning) return;
        m_isRunning = false;
        m_isClosing = true;
    }
    m_wake.notify();
    pthread_join(m_thread, nullptr);
    const Counts all = counts();
    dxLog(dxLogLevel::Info,
          "remote workers: %llu islands sent, %llu solved there, %llu reclaimed; late %u times, %u workers lost, %u replaced; "
          "waited for them %.3f ms",
          static_cast<unsigned long long>(all.sent), static_cast<unsigned long long>(all.outcomes.solved()),
          static_cast<unsigned long long>(all.outcomes.returned()), all.late, all.lost, all.replaced, all.waitedNs / 1e6);
}

// The communication thread and the workers belong to the parent. A handler of a signal may have forked in the middle of a step; the child
// continues that step alone (dxRemoteBatch::next()).
void dxRemoteWorkers::inForkedChild() {
    m_scheduler.setNoneThere();
    m_isRunning = m_isCommunicating = false;
    m_isForAllThreads = false;
    ++m_forks;
    m_scheduler.news().inForkedChild();
}

dxRemoteCapacity dxRemoteWorkers::capacity() {
    const dxRemoteLock lock(m_mutex);
    return m_scheduler.capacity();
}

void dxRemoteWorkers::wake() {
    const dxRemoteLock lock(m_mutex);
    m_messenger.wakeAll();
    m_wake.notify();
}

dxRemoteWorkers::Counts dxRemoteWorkers::counts() {
    const dxRemoteLock lock(m_mutex);
    return m_scheduler.counts();
}

// --- on the communication thread ----------------------------------------------------------------------------

void dxRemoteWorkers::communicate() {
    pthread_setname_np(pthread_self(), kThreadName);
    begin();
    dxRemoteLock lock(m_mutex);
    bool isOver = false;
    while (!m_isClosing && !(isOver = isProcessOver(lock))) {
        awaitTurn(lock);
        m_isCommunicating = true;
        bool hasDone = m_messenger.exchange(lock);
        hasDone |= m_replacement.advance(lock);
        m_isCommunicating = false;
        m_scheduler.noticeLate();
        if (hasDone)
            m_pause.reset();
        else
            sleep(lock);
    }
    m_isClosing = true;
    awaitTurn(lock);
    m_scheduler.reclaimQueue();
    if (isOver) m_isRunning = false;  // exit handlers need not close it again
    lock.unlock();
    end();
    if (isOver) std::exit(0);
}

// Threads of MPI may still run, so that the end of this thread would not end the process.
bool dxRemoteWorkers::isProcessOver(dxRemoteLock &lock) {
    if (!m_isOver || m_scheduler.now() - m_lastLook < kOverLookNs) return false;
    m_lastLook = m_scheduler.now();
    const dxUnlocked others(lock);
    try {
        return m_isOver();
    } catch (const std::bad_alloc &) {
        return false;
    }
}

// Reserves the next turn; otherwise several threads that step worlds would go on taking it from each other.
void dxRemoteWorkers::awaitTurn(dxRemoteLock &lock) {
    m_isTurnAwaited = true;
    while (m_isCommunicating) m_turn.wait(lock);
    m_isTurnAwaited = false;
}

void dxRemoteWorkers::begin() {
    std::vector<dxRemoteWorker> workers;
    const auto haveNone = [this](const char *why) {
        dxLog(dxLogLevel::Warning, "remote workers: none by %s: %s; islands stay in this process", m_name.c_str(), why);
        if (m_transport) m_transport->close(false);
        m_transport.reset();
    };
    try {
        std::string reason;
        m_transport = m_open(reason);
        if (!m_transport)
            haveNone(reason.c_str());
        else if (workers.resize(m_transport->links()); !reason.empty())
            dxLog(dxLogLevel::Warning, "remote workers: %zu by %s, fewer than wanted: %s", workers.size(), m_name.c_str(), reason.c_str());
    } catch (const std::exception &fault) {
        haveNone(fault.what());
    } catch (...) {
        haveNone("an exception");
    }
    if (m_transport) m_transport->setEnd([] { instance().close(); });
    const dxRemoteLock lock(m_mutex);
    m_scheduler.begin(workers);
    m_replacement.begin(m_transport.get());
    m_messenger.begin(m_hello, m_transport.get());
    m_isForAllThreads = m_transport && m_transport->isForAllThreads();
    m_hasBegun = true;
    m_scheduler.news().notify();
}

// Returns whether messages are expected. They do not wake this thread, so it has to look for them.
bool dxRemoteWorkers::isPolled() const {
    return m_scheduler.any([](const dxRemoteWorker &one) { return !one.isSettled() || !one.link.inFlight().empty(); });
}

void dxRemoteWorkers::sleep(dxRemoteLock &lock) {
    if (isPolled()) return sleepBetweenLooks(lock);
    m_isAsleep = true;
    m_wake.waitFor(lock, duration(m_replacement.isNeeded() ? kRestartPollNs : kOverLookNs),
                   [this] { return m_isClosing || m_messenger.hasSomethingToSay() || isPolled(); });
    m_isAsleep = false;
}

// This thread looks for messages of late workers less and less often, so that a worker that never answers costs little. While other threads look, it
// looks in case they have long islands to solve.
void dxRemoteWorkers::sleepBetweenLooks(dxRemoteLock &lock) {
    const bool isMeasured = m_scheduler.any([](const dxRemoteWorker &one) { return one.link.state() == dxRemoteLink::State::Measured; });
    if (m_scheduler.now() - m_polledAt < kPolledNs) {
        m_wake.waitFor(lock, duration(kPolledNs));
    } else if (isMeasured && m_pause.isAtOnce(kEchoMoment)) {
        const dxUnlocked others(lock);
    } else {
        m_wake.waitFor(lock, m_isForAllThreads ? m_pause.next(kMaxBesideOthersNs) : m_pause.next());
    }
}

// Waits for results that are no longer needed, and for a worker that is being started.
void dxRemoteWorkers::drain(dxRemoteLock &lock) {
    const double begin = m_scheduler.now();
    const auto isIdle = [](const dxRemoteWorker &one) { return one.link.inFlight().empty() || one.link.isLate() || one.isLost(); };
    try {
        while (!m_scheduler.all(isIdle) && m_scheduler.now() - begin < kDrainNs) {
            if (!m_messenger.receive(lock)) m_wake.waitFor(lock, std::chrono::milliseconds(1));
            m_scheduler.noticeLate();
        }
    } catch (...) {
        m_scheduler.dropAll("an exception");
    }
    while (m_replacement.isStarting() && !m_replacement.takeStarted() && m_scheduler.now() - begin < kMaxStartNs)
        m_wake.waitFor(lock, duration(kRestartPollNs));
}

void dxRemoteWorkers::end() {
    if (!m_transport) return;
    dxRemoteLock lock(m_mutex);
    m_scheduler.setNoneThere();
    drain(lock);
    // All of them answer, so the wait ends.
    bool isOrderly = !m_replacement.isStarting() && !m_scheduler.hasLost() &&
                     m_scheduler.all([](const dxRemoteWorker &one) { return one.isOpen() && one.link.inFlight().empty(); });
    std::vector<dxRemoteWorker> &workers = m_scheduler.workers();
    for (unsigned i = 0; i < workers.size(); ++i) {
        if (workers[i].isUnreachable) continue;
        m_messenger.sendQuit(i, isOrderly, lock);
        if (workers[i].isLost()) isOrderly = false;
    }
    workers.clear();
    lock.unlock();
    try {
        m_transport->close(isOrderly);
    } catch (...) {
        dxLog(dxLogLevel::Warning, "remote workers: an exception at their end");
    }
    m_transport.reset();
}

// --- on threads that step worlds ----------------------------------------------------------------------------

void dxRemoteWorkers::poll(bool isUrgent) {
    if (!m_isForAllThreads || (!isUrgent && m_scheduler.now() - m_polledAt < kRemoteBetweenLooksNs)) return;
    const dxUndisturbed whole;
    dxRemoteLock lock(m_mutex);
    poll(lock);
}

// Requires dxUndisturbed. Sends and receives until nothing is left, or until signals have been blocked for long enough. Returns whether there was
// anything.
bool dxRemoteWorkers::poll(dxRemoteLock &lock) {
    if (!m_isForAllThreads || m_isCommunicating || m_isTurnAwaited || m_isClosing) return false;
    m_isCommunicating = true;
    const double end = m_scheduler.now() + kMaxAtOnceNs;
    bool hasDone = false;
    while (m_messenger.exchange(lock)) {
        hasDone = true;
        if (m_scheduler.now() >= end) break;
    }
    m_isCommunicating = false;
    if (hasDone) m_pause.reset();
    m_polledAt = m_scheduler.now();
    m_turn.notify();
    return hasDone;
}

// Called when there are messages to send, or results are expected.
void dxRemoteWorkers::notify() {
    if (!m_isForAllThreads || m_isAsleep) m_wake.notify();
}

// Looks at once, for a moment. Releases the lock before handlers of signals that have come meanwhile run.
bool dxRemoteWorkers::lookForNews(dxRemoteLock &lock, const dxPollPause &pause) {
    const dxUnlocked handlers(lock);
    const dxUndisturbed whole;
    dxRemoteLock again(m_mutex);
    while (!poll(again)) {
        if (!pause.isAtOnce()) return false;
        const dxUnlocked others(again);
    }
    return true;
}

// Waits for this time at most. One thread looks for messages itself, if it may; it notifies the others.
void dxRemoteWorkers::waitForNews(dxRemoteLock &lock, dxPollPause &pause, double ns) {
    if (m_isForAllThreads && m_scheduler.waiting() == 1) {
        if (lookForNews(lock, pause)) return pause.reset();
        ns = std::min(ns, static_cast<double>(pause.next().count()));
    }
    const dxNoCancellation whole;
    if (std::isinf(ns))
        m_scheduler.news().wait(lock);
    else
        m_scheduler.news().waitFor(lock, duration(std::max(ns, 1e3)));
}
