#include "remote/coordinator/dxRemoteWorkers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

#include "core/dxGuards.h"
#include "core/dxLog.h"
#include "remote/coordinator/dxRemoteNumber.h"
#include "remote/coordinator/dxRemoteSchedule.h"
#include "threading/pool/dxWorkerOptions.h"

namespace {

// To be measured, a link carries small messages, and then large ones; the fastest of them count.
// While one is awaited this thread keeps its core, so that a worker on the same core is moved to another one, as soon as the scheduler looks (4 ms).
constexpr std::chrono::milliseconds kEchoMoment{20};
constexpr unsigned kSmallEchoes = 4, kLargeEchoes = 3;
constexpr std::size_t kLargeEcho = std::size_t{256} << 10;  // bytes

constexpr double kHeartbeatNs = 5e9;    // home says that it is there
constexpr double kLookNs = 1e9;         // between two looks at whether the program's threads have ended
constexpr double kSettleNs = 2e9;       // open() waits so long for workers
constexpr double kGreetingNs = 10e9;    // a worker in the place of another one is usable in so long, or lost
constexpr double kRestartPollNs = 20e6; // between two looks at whether a worker has started
constexpr double kMaxStartNs = 3e9;     // close() waits so long for a worker that is being started
constexpr double kDrainNs = 1e9;        // close() waits so long for results that nobody needs, so that all can end in good order
constexpr double kHelpedNs = 400e3;       // nor does the communication thread, when home has looked within that time
constexpr double kMostAtOnceNs = 100e3;   // a look of home's ends, though there is more to do
constexpr double kMostBesideHomeNs = 2e6; // between two looks of that thread's, while home's may look: it takes cores from those that solve
constexpr double kPatienceNs = 3e9;     // a step that waits for workers takes home what has not been sent when nothing has happened for so long

dxProcessObject<dxRemoteWorkers> remoteWorkers;

std::chrono::nanoseconds duration(double ns) { return std::chrono::nanoseconds(static_cast<std::int64_t>(ns)); }

class CountedWait {
public:
    explicit CountedWait(unsigned &count) : m_count(count) { ++m_count; }
    ~CountedWait() { --m_count; }
    CountedWait(const CountedWait &) = delete;
    CountedWait &operator=(const CountedWait &) = delete;

private:
    unsigned &m_count;
};

}  // namespace

// Problems of one message, and their bytes.
struct dxRemoteSending {
    std::uint64_t number = 0;
    std::vector<std::uint64_t> problems;
    std::vector<dxRemoteBytes> bytes;
};

dxRemoteWorkers &dxRemoteWorkers::instance() { return *remoteWorkers; }

double dxRemoteWorkers::now() const {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - m_start).count();
}

void dxRemoteWorkers::open(const char *name, const dxRemoteHello &hello, Open open, std::chrono::nanoseconds most) {
    const dxNoCancellation whole;
    Lock lock(m_mutex);
    if (m_isRunning) return;
    m_name = name;
    m_hello = hello;
    m_open = std::move(open);
    m_isClosing = m_hasBegun = m_isWaking = m_isCommunicating = m_isTurnAwaited = m_isAsleep = false;
    m_isForAllThreads = false;
    m_queue.clear();  // in a child of fork() those of the parent's threads
    const auto body = [](void *self) -> void * {
        static_cast<dxRemoteWorkers *>(self)->communicate();
        return nullptr;
    };
    const int error = dxStartThread(pthread_create, m_thread, body, this, dxWorkerOptions());
    if (error != 0) {
        dxLog(dxLogLevel::warning, "remote workers: no thread to communicate (error %d); islands stay at home", error);
        return;
    }
    if (!m_done.waitFor(lock, most, [this] { return m_hasBegun; })) return leaveAlone(lock);
    m_isRunning = true;
    m_done.waitFor(lock, duration(kSettleNs), [this] { return isSettled(); });
    if (m_links.empty()) return;
    lock.unlock();
    const dxRemoteCapacity all = capacity();
    dxLog(all.workers == 0 ? dxLogLevel::warning : dxLogLevel::info,
          "remote workers: %u of %zu by %s; latency %.0f us, %.2f GB/s", all.workers, m_links.size(), name, all.latencyNs / 1e3,
          all.nsPerByte > 0 ? 1 / all.nsPerByte : 0);
}

// What the transport waits for may never come: a worker that has ended before it could join. If it does, the thread ends what has begun.
void dxRemoteWorkers::leaveAlone(Lock &lock) {
    m_isClosing = true;
    pthread_detach(m_thread);
    lock.unlock();
    dxLog(dxLogLevel::warning, "remote workers: none by %s: it does not begin; islands stay at home", m_name.c_str());
}

void dxRemoteWorkers::close() {
    const dxNoCancellation whole;
    {
        const Lock lock(m_mutex);
        if (!m_isRunning) return;
        m_isRunning = false;
        m_isClosing = true;
    }
    m_wake.notify();
    pthread_join(m_thread, nullptr);
    const Counts all = counts();
    dxLog(dxLogLevel::info, "remote workers: %llu islands sent, %llu solved there, %llu taken back; late %u times, %u workers lost, %u replaced; home waited %.3f ms",
          static_cast<unsigned long long>(all.sent), static_cast<unsigned long long>(all.outcomes.solved()),
          static_cast<unsigned long long>(all.outcomes.returned()), all.late, all.lost, all.replaced, all.waitedNs / 1e6);
}

// The communication thread is the parent's, and so are the workers. A handler of a signal may have forked in the middle of a step, which the child goes on
// with, at home (dxRemoteBatch::next()).
void dxRemoteWorkers::inForkedChild() {
    m_areThere.store(false, std::memory_order_relaxed);
    m_isRunning = m_isCommunicating = false;
    m_isForAllThreads = false;
    ++m_forks;
    m_done.inForkedChild();
}

dxRemoteCapacity dxRemoteWorkers::capacity() {
    const Lock lock(m_mutex);
    dxRemoteCapacity sum;
    if (!areThere()) return sum;
    const double time = now();
    for (const Link &one : m_links)
        if (one.link.isUsable(time)) sum.add(one.link, time);
    return sum;
}

void dxRemoteWorkers::wake() {
    const Lock lock(m_mutex);
    m_isWaking = true;
    m_wake.notify();
}

dxRemoteWorkers::Counts dxRemoteWorkers::counts() {
    const Lock lock(m_mutex);
    Counts counts = m_counts;
    if (!areThere()) return counts;
    const double time = now();
    for (const Link &one : m_links) {
        if (one.link.state() != dxRemoteLink::State::Open) continue;
        ++counts.open;
        counts.openLate += !one.link.isUsable(time);
    }
    return counts;
}

// --- on the communication thread ----------------------------------------------------------------------------

void dxRemoteWorkers::communicate() {
    pthread_setname_np(pthread_self(), kThreadName);
    begin();
    Lock lock(m_mutex);
    bool isOver = false;
    while (!m_isClosing && !(isOver = isProcessOver(lock))) {
        awaitTurn(lock);
        m_isCommunicating = true;
        bool hasDone = communicateOnce(lock);
        if (m_canReplace) hasDone |= replaceLost(lock);
        m_isCommunicating = false;
        noticeLate(now());
        if (hasDone)
            m_pause.reset();
        else
            sleep(lock);
    }
    m_isClosing = true;
    awaitTurn(lock);
    takeQueueHome();
    if (isOver) m_isRunning = false;  // handlers at the exit need not close what is closed here
    lock.unlock();
    end();
    if (isOver) std::exit(0);
}

// Threads of MPI's may go on, so that this one's end would not end the process.
bool dxRemoteWorkers::isProcessOver(Lock &lock) {
    if (!m_isOver || now() - m_lastLook < kLookNs) return false;
    m_lastLook = now();
    const dxUnlocked others(lock);
    try {
        return m_isOver();
    } catch (const std::bad_alloc &) {
        return false;
    }
}

// The next turn: several threads of home's would go on taking it from each other.
void dxRemoteWorkers::awaitTurn(Lock &lock) {
    m_isTurnAwaited = true;
    while (m_isCommunicating) m_turn.wait(lock);
    m_isTurnAwaited = false;
}

void dxRemoteWorkers::begin() {
    std::vector<Link> links;
    const auto haveNone = [this](const char *why) {
        dxLog(dxLogLevel::warning, "remote workers: none by %s: %s; islands stay at home", m_name.c_str(), why);
        if (m_transport) m_transport->close(false);
        m_transport.reset();
    };
    try {
        std::string reason;
        m_transport = m_open(reason);
        if (!m_transport)
            haveNone(reason.c_str());
        else if (links.resize(m_transport->links()); !reason.empty())
            dxLog(dxLogLevel::warning, "remote workers: %zu by %s, fewer than wanted: %s", links.size(), m_name.c_str(), reason.c_str());
    } catch (const std::exception &fault) {
        haveNone(fault.what());
    } catch (...) {
        haveNone("an exception");
    }
    if (m_transport) m_transport->setEnd([] { instance().close(); });
    const Lock lock(m_mutex);
    for (Link &one : links) one.since = now();
    m_links.swap(links);
    m_canReplace = m_transport && m_transport->canReplace();
    m_isForAllThreads = m_transport && m_transport->isForAllThreads();
    m_isReplacing = m_hasLost = false;
    m_hasBegun = true;
    m_done.notify();
}

// --- by whoever has the turn --------------------------------------------------------------------------------

bool dxRemoteWorkers::communicateOnce(Lock &lock) try {
    const bool hasWoken = sendWakeUps(lock), hasWithdrawn = sendWithdrawals(lock), hasSent = sendNext(lock), hasReceived = receiveNext(lock);
    return hasWoken || hasWithdrawn || hasSent || hasReceived;
} catch (const std::exception &fault) {
    loseAll(fault.what());
    return false;
} catch (...) {
    loseAll("an exception");
    return false;
}

bool dxRemoteWorkers::sendTo(unsigned link, const dxRemoteBytes &message, Lock &lock) {
    bool isSent = false;
    {
        const dxUnlocked others(lock);
        isSent = m_transport->send(link, message.data(), message.size());
    }
    if (!isSent) loseUnreachable(link, "cannot be reached");
    if (static_cast<dxRemoteKind>(dxReadHeader(message).kind) != dxRemoteKind::Alive) m_links[link].link.noteContact(now());
    return isSent;
}

// Without memory for the message the worker sleeps on.
bool dxRemoteWorkers::sendWakeUps(Lock &lock) {
    if (!std::exchange(m_isWaking, false)) return false;
    for (unsigned i = 0; i < m_links.size(); ++i) {
        if (!m_links[i].link.isUsable(now()) || !m_links[i].link.isAsleep(now())) continue;
        try {
            sendTo(i, dxRemoteFrame().seal(dxRemoteKind::Wake), lock);
        } catch (const std::bad_alloc &) {
            warnOfMemory();
        }
    }
    return true;
}

// Without memory for the message the worker solves in vain.
bool dxRemoteWorkers::sendWithdrawals(Lock &lock) {
    if (!m_hasWithdrawals) return false;
    m_hasWithdrawals = false;
    for (unsigned i = 0; i < m_links.size(); ++i) {
        for (std::uint64_t number = 0; m_links[i].link.takeWithdrawal(number);) {
            if (m_links[i].link.state() != dxRemoteLink::State::Open) continue;
            try {
                sendTo(i, dxRemoteFrame().seal(dxRemoteKind::Withdraw, number), lock);
            } catch (const std::bad_alloc &) {
                warnOfMemory();
            }
        }
    }
    return true;
}

void dxRemoteWorkers::sendHeartbeat(double time, Lock &lock) {
    if (time - m_lastAlive <= kHeartbeatNs) return;
    m_lastAlive = time;
    for (unsigned i = 0; i < m_links.size(); ++i) {
        const dxRemoteLink::State state = m_links[i].link.state();
        const bool isHeard = state == dxRemoteLink::State::Open ? !m_links[i].link.isLate() : state == dxRemoteLink::State::Lost && !m_canReplace;
        if (!isHeard || m_links[i].isUnreachable) continue;
        try {
            sendTo(i, dxRemoteFrame().seal(dxRemoteKind::Alive), lock);
        } catch (const std::bad_alloc &) {
            warnOfMemory();
        }
    }
}

// The most expensive problems of the queue, to the first link that is free. Towards the end messages become small, so that all workers end at
// the same time.
bool dxRemoteWorkers::sendNext(Lock &lock) {
    const double time = now();
    sendHeartbeat(time, lock);
    if (m_queue.empty()) return false;
    const Link *const best = dxFindFreestLink(m_links, time);
    if (best == nullptr) return false;
    const unsigned link = static_cast<unsigned>(best - m_links.data());
    dxRemoteSending sending;
    if (!takeNext(link, time, sending)) return true;
    bool isSent = false;
    try {
        dxRemoteFrame frame(m_spareMessages.take());
        {
            const dxUnlocked others(lock);
            for (std::size_t i = 0; i < sending.problems.size(); ++i) frame.addItem(sending.problems[i], sending.bytes[i].data(), sending.bytes[i].size());
            const dxRemoteBytes &message = frame.seal(dxRemoteKind::Problems, sending.number);
            isSent = m_transport->send(link, message.data(), message.size());
        }
        m_spareMessages.giveBack(frame.release());
        for (dxRemoteBytes &bytes : sending.bytes) m_spareProblems.giveBack(std::move(bytes));
    } catch (const std::bad_alloc &) {
        warnOfMemory();
        dxRemoteInFlight unsent;
        m_links[link].link.withdraw(sending.number);
        if (m_links[link].link.takeBack(sending.number, now(), unsent)) takeHome(unsent.problems, dxRemoteOutcome::NoResult);
        m_done.notify();
        return true;
    }
    if (!isSent) loseUnreachable(link, "cannot be reached");
    return true;
}

// From the queue to the link. Returns false without memory: then the queue has gone home, and the link has nothing more to do than before.
bool dxRemoteWorkers::takeNext(unsigned link, double time, dxRemoteSending &sending) {
    double queued = 0;
    for (const dxRemoteProblem *problem : m_queue) queued += problem->cost;
    const double most = dxMaxMessageCost(queued, m_links.size());
    dxRemoteInFlight sent{m_nextFrame++, {}, 0, 0, 0};
    std::size_t bytes = 0;
    auto end = m_queue.begin();
    try {
        do {
            const dxRemoteProblem &problem = **end;
            sent.problems.push_back(problem.number);
            sent.cost += problem.cost;
            sent.isPatient |= problem.isPatient;
            bytes += problem.bytes.size();
        } while (++end != m_queue.end() && sent.cost + (*end)->cost <= most);
        sending.number = sent.number;
        sending.problems = sent.problems;
        sending.bytes.reserve(sent.problems.size());
        m_links[link].link.send(std::move(sent), bytes, time);
    } catch (const std::bad_alloc &) {
        warnOfMemory();
        takeQueueHome();
        return false;
    }
    for (auto taken = m_queue.begin(); taken != end; taken = m_queue.erase(taken)) {
        dxRemoteProblem &problem = **taken;
        problem.state = dxRemoteProblem::State::Sent;
        problem.isSent = true;
        problem.link = link;
        sending.bytes.push_back(std::move(problem.bytes));
        ++m_counts.sent;
    }
    return true;
}

bool dxRemoteWorkers::receiveNext(Lock &lock) {
    if (!m_transport) return false;
    unsigned link = 0;
    std::size_t bytes = 0;
    bool isReceived = false;
    const char *fault = nullptr;
    try {
        {
            const dxUnlocked others(lock);
            bytes = m_transport->waiting(link);
            if (m_received.capacity() > dxSpareBytes::kMaxRoom) dxRemoteBytes().swap(m_received);
            m_received.resize(bytes);
            isReceived = bytes != 0 && m_transport->receive(m_received.data());
            fault = isReceived ? dxFindFrameFault(m_received) : nullptr;
        }
        if (bytes == 0 || link >= m_links.size()) return false;
        if (m_links[link].link.state() == dxRemoteLink::State::Lost) return true;  // is not read
        if (!isReceived)
            loseUnreachable(link, "is disconnected");
        else if (fault != nullptr)
            lose(link, "sent a message that is ", fault);
        else
            handle(link, m_received, lock);
    } catch (const std::bad_alloc &) {
        if (bytes == 0 || link >= m_links.size()) throw;
        lose(link, "sent a message for which home has no memory");
    }
    return true;
}

void dxRemoteWorkers::handle(unsigned link, const dxRemoteBytes &message, Lock &lock) {
    switch (static_cast<dxRemoteKind>(dxReadHeader(message).kind)) {
        case dxRemoteKind::Hello: return handleHello(link, message, lock);
        case dxRemoteKind::Echo: return handleEcho(link, message, lock);
        case dxRemoteKind::Results: return handleResults(link, message);
        default: return lose(link, "sent a message that a worker has no reason to send");
    }
}

void dxRemoteWorkers::handleHello(unsigned link, const dxRemoteBytes &message, Lock &lock) {
    dxRemoteHello hello;
    if (message.size() != sizeof(dxRemoteHeader) + sizeof hello) return lose(link, "sent a greeting of another size");
    std::memcpy(&hello, message.data() + sizeof(dxRemoteHeader), sizeof hello);
    hello.version[sizeof hello.version - 1] = '\0';
    std::string why;
    if (std::strcmp(hello.version, m_hello.version) != 0)
        why = "is version " + std::string(hello.version) + " of ODE_MT, not " + m_hello.version;
    else if (hello.realSize != m_hello.realSize)
        why = "computes with numbers of " + std::to_string(hello.realSize) + " bytes, not " + std::to_string(m_hello.realSize);
    else if (hello.digest != m_hello.digest)
        why = "computes other bits for the problems of the self-test";
    if (!why.empty()) {
        m_links[link].isRefused = true;
        dxRemoteFrame refusal;
        refusal.add(why.data(), why.size());
        sendTo(link, refusal.seal(dxRemoteKind::Refusal), lock);
        return lose(link, "", why.c_str());
    }
    m_links[link].link.welcome();
    if (sendTo(link, dxRemoteFrame().seal(dxRemoteKind::Welcome), lock)) sendEcho(link, lock);
}

void dxRemoteWorkers::sendEcho(unsigned link, Lock &lock) {
    dxRemoteFrame echo(m_spareMessages.take());
    if (m_links[link].echoes >= kSmallEchoes) {
        const dxRemoteBytes content(kLargeEcho);
        echo.add(content.data(), content.size());
    }
    const dxRemoteBytes &message = echo.seal(dxRemoteKind::Echo, m_links[link].echoes);
    m_links[link].echoSent = now();
    sendTo(link, message, lock);
    m_spareMessages.giveBack(echo.release());
}

void dxRemoteWorkers::handleEcho(unsigned link, const dxRemoteBytes &message, Lock &lock) {
    Link &one = m_links[link];
    if (one.link.state() != dxRemoteLink::State::Measured || dxReadHeader(message).number != one.echoes) return lose(link, "sent an echo of nothing");
    const double time = now(), took = time - one.echoSent;
    one.link.noteAwake(time);
    if (one.echoes < kSmallEchoes) {
        one.latencyNs = one.echoes == 0 ? took : std::min(one.latencyNs, took);
        ++one.echoes;
        return sendEcho(link, lock);
    }
    one.largeNs = one.echoes == kSmallEchoes ? took : std::min(one.largeNs, took);
    if (++one.echoes < kSmallEchoes + kLargeEchoes) return sendEcho(link, lock);
    one.link.setMeasured(one.latencyNs, std::max(one.largeNs - one.latencyNs, 0.0) / (2.0 * kLargeEcho));
    if (one.isReplacement)
        dxLog(dxLogLevel::info, "remote worker %u is replaced; latency %.0f us, %.2f GB/s", link + 1, one.latencyNs / 1e3, 1 / one.link.nsPerByte());
    noteAvailable();
    m_done.notify();
}

// Of a message that is not what it should be nothing is used. One without results says that its worker could solve none, or was told in time not
// to.
void dxRemoteWorkers::handleResults(unsigned link, const dxRemoteBytes &message) {
    const std::uint64_t number = dxReadHeader(message).number;
    dxRemoteItems all(message);
    std::size_t count = 0;
    while (all.next()) ++count;
    if (count == 0) m_links[link].link.withdraw(number);  // tells nothing of its speed
    dxRemoteInFlight expected;
    if (!m_links[link].link.takeBack(number, now(), expected)) return lose(link, "sent results of nothing");
    bool isSound = all.isAtEnd() && (count == expected.problems.size() || count == 0);
    dxRemoteItems items(message);
    for (std::size_t i = 0; i < count && isSound; ++i) {
        items.next();
        isSound = items.number() == expected.problems[i];
    }
    if (!isSound) {
        takeHome(expected.problems, dxRemoteOutcome::Lost);
        return lose(link, "sent results of other problems");
    }
    try {
        for (dxRemoteItems item(message); item.next();) {
            const auto found = m_batches.find(dxRemoteBatchOf(item.number()));
            if (found == m_batches.end()) continue;  // the step has ended
            dxRemoteBatch &batch = *found->second;
            const unsigned index = dxRemoteIndexOf(item.number());
            dxRemoteProblem &problem = batch.m_problems[index];
            if (problem.state != dxRemoteProblem::State::Sent && problem.state != dxRemoteProblem::State::AtHome) continue;  // home was faster
            problem.bytes.assign(item.data(), item.data() + item.size());
            problem.state = dxRemoteProblem::State::Returned;
            batch.m_returned.push_back(index);
        }
    } catch (const std::bad_alloc &) {
        warnOfMemory();
        takeHome(expected.problems, dxRemoteOutcome::NoResult);
    }
    if (count == 0) takeHome(expected.problems, dxRemoteOutcome::NoResult);
    m_done.notify();
}

// --- workers in the place of lost ones ---

// Returns whether there is news.
bool dxRemoteWorkers::replaceLost(Lock &lock) {
    const double time = now();
    for (unsigned i = 0; i < m_links.size(); ++i) {
        const Link &one = m_links[i];
        const bool isGreeted = one.link.state() == dxRemoteLink::State::Open || one.link.state() == dxRemoteLink::State::Lost;
        if (one.link.isGone(time)) lose(i, "has not answered for seconds");
        if (!isGreeted && time - one.since > kGreetingNs) lose(i, "has not said what it is");
    }
    return m_isReplacing ? takeReplacement() : beginReplacement(time, lock);
}

bool dxRemoteWorkers::takeReplacement() {
    const dxRemoteTransport::Replacement replacement = m_transport->replacement();
    if (replacement == dxRemoteTransport::Replacement::Expected) return false;
    m_isReplacing = false;
    Link &one = m_links[m_replacedLink];
    if (replacement == dxRemoteTransport::Replacement::Failed) {
        dxLog(dxLogLevel::warning, "remote worker %u cannot be replaced", m_replacedLink + 1);
        one.restart.begin(now(), false);
        m_canReplace = m_transport->canReplace();
        return true;
    }
    ++m_counts.replaced;
    one.link = dxRemoteLink();
    one.isUnreachable = false;
    one.echoes = 0;
    one.since = now();
    one.isReplacement = true;
    return true;
}

// The lost worker may be alive.
bool dxRemoteWorkers::beginReplacement(double time, Lock &lock) {
    const auto found = std::find_if(m_links.begin(), m_links.end(), [time](const Link &one) {
        return one.link.state() == dxRemoteLink::State::Lost && !one.isRefused && one.restart.isOver(time);
    });
    if (found == m_links.end()) return false;
    m_replacedLink = static_cast<unsigned>(found - m_links.begin());
    m_isReplacing = true;
    sendQuit(m_replacedLink, false, lock);
    m_transport->replace(m_replacedLink);
    return true;
}

// A late worker is looked for less and less often; one that has gone for good costs nothing that matters. While home's threads look, this one
// is there in case they have long islands to solve.
void dxRemoteWorkers::sleep(Lock &lock) {
    const auto isPolled = [this] {
        return std::any_of(m_links.begin(), m_links.end(), [](const Link &one) {
            const dxRemoteLink::State state = one.link.state();
            return state == dxRemoteLink::State::New || state == dxRemoteLink::State::Measured || !one.link.inFlight().empty();
        });
    };
    if (isPolled()) {
        const bool isMeasured = std::any_of(m_links.begin(), m_links.end(), [](const Link &one) { return one.link.state() == dxRemoteLink::State::Measured; });
        if (now() - m_helpedAt < kHelpedNs) {
            m_wake.waitFor(lock, duration(kHelpedNs));
        } else if (isMeasured && m_pause.isAtOnce(kEchoMoment)) {
            const dxUnlocked others(lock);
        } else {
            m_wake.waitFor(lock, m_isForAllThreads ? m_pause.next(kMostBesideHomeNs) : m_pause.next());
        }
    } else {
        const bool isReplaced = m_canReplace && std::any_of(m_links.begin(), m_links.end(), [](const Link &one) {
            return one.link.state() == dxRemoteLink::State::Lost && !one.isRefused;
        });
        m_isAsleep = true;
        m_wake.waitFor(lock, duration(isReplaced ? kRestartPollNs : kLookNs), [&] { return hasSomethingToSay() || isPolled(); });
        m_isAsleep = false;
    }
}

void dxRemoteWorkers::end() {
    if (!m_transport) return;
    Lock lock(m_mutex);
    m_areThere.store(false, std::memory_order_relaxed);
    const double begin = now();
    const auto isIdle = [this] {
        return std::all_of(m_links.begin(), m_links.end(), [](const Link &one) {
            return one.link.inFlight().empty() || one.link.isLate() || one.link.state() == dxRemoteLink::State::Lost;
        });
    };
    try {
        while (!isIdle() && now() - begin < kDrainNs) {
            if (!receiveNext(lock)) m_wake.waitFor(lock, std::chrono::milliseconds(1));
            noticeLate(now());
        }
    } catch (...) {
        loseAll("an exception");
    }
    while (m_isReplacing && !takeReplacement() && now() - begin < kMaxStartNs) m_wake.waitFor(lock, duration(kRestartPollNs));
    // All of them answer, so none is waited for in vain.
    bool isOrderly = !m_isReplacing && !m_hasLost && std::all_of(m_links.begin(), m_links.end(), [](const Link &one) {
        return one.link.state() == dxRemoteLink::State::Open && one.link.inFlight().empty();
    });
    for (unsigned i = 0; i < m_links.size(); ++i) {
        if (m_links[i].isUnreachable) continue;
        sendQuit(i, isOrderly, lock);
        if (m_links[i].link.state() == dxRemoteLink::State::Lost) isOrderly = false;
    }
    m_links.clear();
    lock.unlock();
    try {
        m_transport->close(isOrderly);
    } catch (...) {
        dxLog(dxLogLevel::warning, "remote workers: an exception at their end");
    }
    m_transport.reset();
}

// A worker that cannot be told ends when it has not heard of home for a while.
void dxRemoteWorkers::sendQuit(unsigned link, bool isOrderly, Lock &lock) {
    const std::byte body{isOrderly};
    try {
        dxRemoteFrame quit;
        quit.add(&body, 1);
        sendTo(link, quit.seal(dxRemoteKind::Quit), lock);
    } catch (...) {
        lose(link, "cannot be told to end");
    }
}

// --- under the lock -----------------------------------------------------------------------------------------

bool dxRemoteWorkers::isSettled() const {
    return std::all_of(m_links.begin(), m_links.end(), [](const Link &one) {
        return one.link.state() == dxRemoteLink::State::Open || one.link.state() == dxRemoteLink::State::Lost;
    });
}

void dxRemoteWorkers::noteAvailable() {
    m_areThere.store(std::any_of(m_links.begin(), m_links.end(), [](const Link &one) { return one.link.state() == dxRemoteLink::State::Open; }),
                     std::memory_order_relaxed);
}

void dxRemoteWorkers::lose(unsigned link, const char *why, const char *detail) {
    if (m_links[link].link.state() == dxRemoteLink::State::Lost) return;
    dxLog(dxLogLevel::warning, "remote worker %u %s%s; it is left out", link + 1, why, detail);
    m_links[link].restart.begin(now(), m_links[link].link.hasProved());
    m_links[link].link.lose();
    ++(m_links[link].isRefused ? m_counts.refused : m_counts.lost);
    m_hasLost = true;
    for (const dxRemoteInFlight &lost : m_links[link].link.inFlight()) takeHome(lost.problems, dxRemoteOutcome::Lost);
    noteAvailable();
    const double time = now();
    if (std::none_of(m_links.begin(), m_links.end(), [time](const Link &one) { return one.link.isUsable(time); })) takeQueueHome();
    m_done.notify();
}

void dxRemoteWorkers::loseUnreachable(unsigned link, const char *why) {
    m_links[link].isUnreachable = true;
    lose(link, why);
}

void dxRemoteWorkers::loseAll(const char *why) {
    dxLog(dxLogLevel::warning, "remote workers: %s; islands stay at home", why);
    for (unsigned i = 0; i < m_links.size(); ++i) lose(i, "cannot be talked to");
    takeQueueHome();
}

void dxRemoteWorkers::warnOfMemory() {
    if (std::exchange(m_hasWarnedOfMemory, true)) return;
    dxLog(dxLogLevel::warning, "remote workers: no memory for a message; its islands stay at home");
}

// `why`: if it was sent.
void dxRemoteWorkers::takeHome(dxRemoteProblem &problem, dxRemoteOutcome why) {
    if (problem.state != dxRemoteProblem::State::Queued && problem.state != dxRemoteProblem::State::Sent) return;
    problem.state = dxRemoteProblem::State::AtHome;
    problem.outcome = why;
    m_batches[dxRemoteBatchOf(problem.number)]->m_atHome.push_back(dxRemoteIndexOf(problem.number));
}

void dxRemoteWorkers::takeHome(const std::vector<std::uint64_t> &problems, dxRemoteOutcome why) {
    for (const std::uint64_t number : problems) {
        const auto found = m_batches.find(dxRemoteBatchOf(number));
        if (found != m_batches.end()) takeHome(found->second->m_problems[dxRemoteIndexOf(number)], why);
    }
}

void dxRemoteWorkers::takeQueueHome() {
    for (dxRemoteProblem *problem : m_queue) takeHome(*problem, dxRemoteOutcome::Late);
    m_queue.clear();
    m_done.notify();
}

// Of a step that is under way.
bool dxRemoteWorkers::isSolving(const dxRemoteLink &link) const {
    return !link.inFlight().empty() && m_batches.count(dxRemoteBatchOf(link.inFlight().front().problems.front())) != 0;
}

// What is late while home has enough to do costs nothing, and home comes to know how long problems take.
void dxRemoteWorkers::noticeLate(double time) {
    bool isAnyUsable = false;
    for (Link &one : m_links) {
        const bool isAwaited = m_waiting != 0 || !isSolving(one.link);
        if (isAwaited && one.link.noticeLate(time)) {
            ++m_counts.late;
            dxLog(dxLogLevel::debug, "remote worker %zu is late", static_cast<std::size_t>(&one - m_links.data()) + 1);
            for (const dxRemoteInFlight &late : one.link.inFlight()) takeHome(late.problems, dxRemoteOutcome::Late);
            m_done.notify();
        }
        isAnyUsable |= one.link.isUsable(time);
    }
    if (!isAnyUsable && !m_queue.empty()) takeQueueHome();
}

// --- on home's threads --------------------------------------------------------------------------------------

void dxRemoteWorkers::help(bool isUrgent) {
    if (!m_isForAllThreads || (!isUrgent && now() - m_helpedAt < kRemoteBetweenLooksNs)) return;
    const dxUndisturbed whole;
    Lock lock(m_mutex);
    help(lock);
}

// Under dxUndisturbed. All that there is to do, but for what would hold up signals. Returns whether there was anything.
bool dxRemoteWorkers::help(Lock &lock) {
    if (!m_isForAllThreads || m_isCommunicating || m_isTurnAwaited || m_isClosing) return false;
    m_isCommunicating = true;
    const double end = now() + kMostAtOnceNs;
    bool hasDone = false;
    while (communicateOnce(lock)) {
        hasDone = true;
        if (now() >= end) break;
    }
    m_isCommunicating = false;
    if (hasDone) m_pause.reset();
    m_helpedAt = now();
    m_turn.notify();
    return hasDone;
}

// That there is something to say or to be looked for.
void dxRemoteWorkers::tell() {
    if (!m_isForAllThreads || m_isAsleep) m_wake.notify();
}

// At once, for a moment. The lock is not held when signals that have come meanwhile are handled.
bool dxRemoteWorkers::lookForNews(Lock &lock, const dxPollPause &pause) {
    const dxUnlocked handlers(lock);
    const dxUndisturbed whole;
    Lock again(m_mutex);
    while (!help(again)) {
        if (!pause.isAtOnce()) return false;
        const dxUnlocked others(again);
    }
    return true;
}

// For so long at most. One that may look itself does, the others are told.
void dxRemoteWorkers::waitForNews(Lock &lock, dxPollPause &pause, double ns) {
    if (m_isForAllThreads && m_waiting == 1) {
        if (lookForNews(lock, pause)) return pause.reset();
        ns = std::min(ns, static_cast<double>(pause.next().count()));
    }
    const dxNoCancellation whole;
    if (std::isinf(ns))
        m_done.wait(lock);
    else
        m_done.waitFor(lock, duration(std::max(ns, 1e3)));
}

// --- batches ------------------------------------------------------------------------------------------------

dxRemoteBatch::dxRemoteBatch(dxRemoteWorkers &workers, unsigned count, bool mayHurry)
    : m_workers(workers), m_mayHurry(mayHurry), m_problems(count), m_left(count) {
    m_returned.reserve(count);
    m_atHome.reserve(2 * std::size_t(count));  // once when its worker is late or lost, and again if what then came back was no result
    for (dxRemoteProblem &problem : m_problems) m_nodes.push_back(&problem);
    const dxRemoteWorkers::Lock lock(workers.m_mutex);
    m_number = workers.m_nextBatch++;
    m_forks = workers.m_forks;
    for (unsigned i = 0; i < count; ++i) m_problems[i].number = dxRemoteNumber(m_number, i);
    workers.m_batches[m_number] = this;
}

dxRemoteBatch::~dxRemoteBatch() {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    m_workers.m_batches.erase(m_number);
    std::list<dxRemoteProblem *> &queue = m_workers.m_queue;
    queue.erase(std::remove_if(queue.begin(), queue.end(), [this](const dxRemoteProblem *one) { return dxRemoteBatchOf(one->number) == m_number; }),
                queue.end());
}

void dxRemoteBatch::submit(unsigned index, dxRemoteBytes &&bytes, double cost) {
    const bool isAnyIdle = queue(index, std::move(bytes), cost);
    m_workers.help(isAnyIdle);
}

bool dxRemoteBatch::queue(unsigned index, dxRemoteBytes &&bytes, double cost) {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    dxRemoteProblem &problem = m_problems[index];
    problem.bytes = std::move(bytes);
    problem.cost = m_pace * cost;
    problem.isPatient = !m_mayHurry;
    problem.state = State::Queued;
    if (!m_workers.areThere() || m_workers.m_isClosing) {
        m_workers.takeHome(problem, dxRemoteOutcome::Lost);
        return false;
    }
    std::list<dxRemoteProblem *> &queue = m_workers.m_queue;
    m_nodes.front() = &problem;
    queue.splice(std::upper_bound(queue.begin(), queue.end(), &problem,
                                  [](const dxRemoteProblem *a, const dxRemoteProblem *b) { return a->cost > b->cost; }),
                 m_nodes, m_nodes.begin());
    m_workers.tell();
    return dxIsAnyIdle(m_workers.m_links, m_workers.now());
}

dxRemoteBytes dxRemoteBatch::room() {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    return m_workers.m_spareProblems.take();
}

void dxRemoteBatch::keep(unsigned index) {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    m_problems[index].state = State::AtHome;
    m_atHome.push_back(index);
    m_workers.m_done.notify();
}

void dxRemoteBatch::drop(unsigned index) {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    m_problems[index].state = State::Done;
    --m_left;
    m_workers.m_done.notify();
}

void dxRemoteBatch::reject(unsigned index) {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    m_workers.lose(m_problems[index].link, "sent a result that is none");
    ++m_left;
    m_problems[index].state = State::AtHome;
    m_problems[index].outcome = dxRemoteOutcome::Lost;
    m_atHome.push_back(index);
    discount(dxRemoteOutcome::Solved);
}

void dxRemoteBatch::noteGivenBack() {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    discount(dxRemoteOutcome::Solved);
    count(dxRemoteOutcome::NoResult);
}

// Costs are predicted, and in a scene that settles problems may take many times as long from one step to the next: those of one step are alike.
void dxRemoteBatch::noteHome(double cost, double ns) {
    constexpr double kChange = 1.1, kMost = 1e4;
    if (!(cost > 0)) return;
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    m_homeCost += cost;
    m_homeNs += ns;
    const double factor = std::clamp(m_homeNs / m_homeCost, 1 / kMost, kMost) / m_pace;
    if (factor < kChange && factor > 1 / kChange) return;
    m_pace *= factor;
    for (dxRemoteProblem &problem : m_problems) problem.cost *= factor;
    for (dxRemoteWorkers::Link &one : m_workers.m_links) one.link.rescale(m_number, factor);
}

dxRemoteOutcomes dxRemoteBatch::outcomes() const {
    const dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    return m_outcomes;
}

void dxRemoteBatch::count(dxRemoteOutcome outcome) {
    ++m_outcomes[outcome];
    ++m_workers.m_counts.outcomes[outcome];
}

void dxRemoteBatch::discount(dxRemoteOutcome outcome) {
    --m_outcomes[outcome];
    --m_workers.m_counts.outcomes[outcome];
}

// What has been answered twice in the meantime is in both lists.
bool dxRemoteBatch::takeReady(State state, unsigned &index, dxRemoteBytes *result) {
    std::vector<unsigned> &list = state == State::Returned ? m_returned : m_atHome;
    while (!list.empty()) {
        index = list.back();
        list.pop_back();
        dxRemoteProblem &problem = m_problems[index];
        if (problem.state != state) continue;
        problem.state = State::Done;
        if (problem.isSent) count(state == State::Returned ? dxRemoteOutcome::Solved : problem.outcome);
        if (result != nullptr) *result = std::move(problem.bytes);
        --m_left;
        return true;
    }
    return false;
}

bool dxRemoteBatch::takeUnsent(unsigned &index) {
    std::list<dxRemoteProblem *> &queue = m_workers.m_queue;
    const auto found = std::find_if(queue.rbegin(), queue.rend(), [this](const dxRemoteProblem *one) { return dxRemoteBatchOf(one->number) == m_number; });
    if (found == queue.rend()) return false;
    dxRemoteProblem &problem = **found;
    queue.erase(std::next(found).base());
    problem.state = State::Done;
    index = dxRemoteIndexOf(problem.number);
    --m_left;
    return true;
}

// In a child of fork(), where there are no workers.
void dxRemoteBatch::takeAllHome() {
    m_forks = m_workers.m_forks;
    for (dxRemoteProblem &problem : m_problems) m_workers.takeHome(problem, dxRemoteOutcome::Lost);
}

// Takes the problems home that are expected last, if home would have solved them before.
bool dxRemoteBatch::withdrawLast(double now) {
    unsigned link = 0;
    const dxRemoteInFlight *last = nullptr;
    for (unsigned i = 0; i < m_workers.m_links.size(); ++i) {
        for (const dxRemoteInFlight &sent : m_workers.m_links[i].link.inFlight()) {
            if (sent.isWithdrawn || dxRemoteBatchOf(sent.problems.front()) != m_number) continue;
            if (last != nullptr && sent.expected <= last->expected) continue;
            last = &sent;
            link = i;
        }
    }
    if (last == nullptr || !dxIsSoonerAtHome(last->cost, last->expected, now)) return false;
    m_workers.m_hasWithdrawals = true;
    m_workers.m_links[link].link.withdraw(last->number);
    m_workers.takeHome(last->problems, dxRemoteOutcome::Sooner);
    m_workers.tell();
    return true;
}

double dxRemoteBatch::nextDeadline() const {
    double first = std::numeric_limits<double>::infinity();
    for (const dxRemoteWorkers::Link &one : m_workers.m_links) first = std::min(first, one.link.deadline());
    return first;
}

dxRemoteBatch::Next dxRemoteBatch::next(unsigned &index, dxRemoteBytes &result) {
    dxRemoteWorkers::Lock lock(m_workers.m_mutex);
    const double begin = m_workers.now();
    dxPollPause pause;
    for (;;) {
        if (m_forks != m_workers.m_forks) takeAllHome();
        if (takeReady(State::Returned, index, &result)) return Next::Result;
        if (takeReady(State::AtHome, index, nullptr)) return Next::AtHome;
        if (m_left == 0) {
            m_workers.m_done.notify();  // others that wait for the last one
            return Next::None;
        }
        const double time = m_workers.now();
        const bool hurries = m_mayHurry || time - begin > kPatienceNs;
        if (hurries && takeUnsent(index)) return Next::AtHome;
        const CountedWait wait(m_workers.m_waiting);
        m_workers.noticeLate(time);
        if (!m_atHome.empty() || (m_mayHurry && withdrawLast(time))) continue;
        const double deadline = std::min(nextDeadline(), hurries ? std::numeric_limits<double>::infinity() : begin + 1.01 * kPatienceNs);
        m_workers.waitForNews(lock, pause, deadline - time);
        m_workers.m_counts.waitedNs += m_workers.now() - time;
    }
}
