#include "remote/worker/dxSimulatedNetwork.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "core/dxGuards.h"

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace {

// A worker that has looked so lately is going to again.
constexpr std::chrono::microseconds kLately{200};

std::chrono::nanoseconds duration(double ns) { return std::chrono::nanoseconds(static_cast<std::int64_t>(ns)); }

// Linux lets a thread sleep 50 us longer than it asked for, to save wake-ups.
void sleepExactly() {
#ifdef __linux__
    constexpr unsigned long kSlackNs = 1000;
    prctl(PR_SET_TIMERSLACK, kSlackNs);
#endif
}

}  // namespace

std::unique_ptr<dxSimulatedNetwork> dxSimulatedNetwork::open(const dxSimulatedLink &link, const Open &open, std::string &reason) {
    std::unique_ptr<dxSimulatedNetwork> network(new dxSimulatedNetwork(link));
    network->m_thread = std::thread([network = network.get(), open] { network->run(open); });
    {
        Lock lock(network->m_mutex);
        network->m_changed.wait(lock, [&network] { return network->m_state != State::Opening; });
        if (network->m_state == State::Open) return network;
        reason = network->m_reason;
    }
    return nullptr;
}

dxSimulatedNetwork::~dxSimulatedNetwork() {
    if (m_thread.joinable()) close(false);
}

// The direction is free again when the last byte has left; the message is there a delay later.
void dxSimulatedNetwork::put(Direction &direction, dxRemoteBytes &&bytes, Clock::time_point sent) const {
    direction.busyUntil = std::max(direction.busyUntil, sent) + duration(static_cast<double>(bytes.size()) * m_link.nsPerByte);
    direction.messages.push_back({std::move(bytes), direction.busyUntil + duration(m_link.delayNs)});
}

dxRemoteServer::Solve dxSimulatedNetwork::carrying(dxRemoteServer::Solve solve) {
    return [this, solve = std::move(solve)](const std::byte *problem, std::size_t bytes, dxRemoteBytes &result) {
        solve(problem, bytes, result);
        Lock lock(m_mutex);
        lookFromWorker(lock);
    };
}

bool dxSimulatedNetwork::send(unsigned, const void *message, std::size_t bytes) {
    const auto *const from = static_cast<const std::byte *>(message);
    dxRemoteBytes copy(from, from + bytes);
    const Lock lock(m_mutex);
    if (m_isLost) return false;
    const Clock::time_point now = Clock::now();
    put(m_toCoordinator, std::move(copy), now);
    if (!m_isForAllThreads || m_sleepsUntil > now + kBesideWorker) m_wake.notify_one();
    return true;
}

std::size_t dxSimulatedNetwork::waiting(unsigned &link) {
    Lock lock(m_mutex);
    lookFromWorker(lock);
    link = 0;
    const std::deque<Message> &messages = m_toWorker.messages;
    return messages.empty() || messages.front().due > Clock::now() ? 0 : messages.front().bytes.size();
}

bool dxSimulatedNetwork::receive(void *message) {
    const Lock lock(m_mutex);
    const dxRemoteBytes &bytes = m_toWorker.messages.front().bytes;
    std::memcpy(message, bytes.data(), bytes.size());
    m_toWorker.messages.pop_front();
    return true;
}

void dxSimulatedNetwork::close(bool isOrderly) {
    {
        const Lock lock(m_mutex);
        if (m_state == State::Open) m_state = State::Closing;
        m_isOrderly = isOrderly;
    }
    m_wake.notify_one();
    if (m_thread.joinable()) m_thread.join();
}

// --- by whoever looks ---------------------------------------------------------------------------------------------

void dxSimulatedNetwork::lookFromWorker(Lock &lock) {
    if (!m_isForAllThreads || m_state != State::Open) return;
    const bool hasCarried = look(lock);
    m_workerLooked = Clock::now();
    if (!hasCarried) return;
    m_pause.reset();
    if (m_sleepsUntil > m_workerLooked + kBesideWorker) m_wake.notify_one();  // what comes next may be a long problem
}

// Returns whether there was anything to carry. If somebody else looks, that suffices.
bool dxSimulatedNetwork::look(Lock &lock) {
    if (m_isLost || m_isLooking) return false;
    struct Turn {
        explicit Turn(bool &taken) : isTaken(taken) { isTaken = true; }
        ~Turn() { isTaken = false; }
        bool &isTaken;
    } const turn(m_isLooking);
    try {
        const bool hasPassed = passOn(lock), hasTaken = takeIn(lock);
        return hasPassed || hasTaken;
    } catch (const std::bad_alloc &) {  // the message is gone; the coordinator takes the worker to be late
        m_isLost = true;
        return false;
    }
}

bool dxSimulatedNetwork::passOn(Lock &lock) {
    if (m_toCoordinator.messages.empty() || m_toCoordinator.messages.front().due > Clock::now()) return false;
    const dxRemoteBytes message = std::move(m_toCoordinator.messages.front().bytes);
    m_toCoordinator.messages.pop_front();
    const auto send = [&] {
        const dxUnlocked others(lock);
        return m_below->send(0, message.data(), message.size());
    };
    if (!send()) m_isLost = true;
    return true;
}

bool dxSimulatedNetwork::takeIn(Lock &lock) {
    const Clock::time_point now = Clock::now(), sent = m_lastLook + (now - m_lastLook) / 2;
    dxRemoteBytes message;
    bool isReceived = false;
    {
        const dxUnlocked others(lock);
        unsigned link = 0;
        message.resize(m_below->waiting(link));
        isReceived = !message.empty() && m_below->receive(message.data());
    }
    m_lastLook = now;
    if (message.empty()) return false;
    if (isReceived)
        put(m_toWorker, std::move(message), sent);
    else
        m_isLost = true;
    return true;
}

// --- on the thread of the transport below -------------------------------------------------------------------------

void dxSimulatedNetwork::run(const Open &open) {
    sleepExactly();
    m_below = open(m_reason);
    Lock lock(m_mutex);
    m_state = m_below ? State::Open : State::Closed;
    m_isForAllThreads = m_below && m_below->isForAllThreads();
    m_lastLook = Clock::now();
    m_changed.notify_all();
    if (!m_below) return;
    carry(lock);
    lock.unlock();
    m_below->close(m_isOrderly);
    m_below.reset();
}

void dxSimulatedNetwork::carry(Lock &lock) {
    while (m_state == State::Open || !(m_isLost || m_toCoordinator.messages.empty())) {
        if (look(lock))
            m_pause.reset();
        else
            m_wake.wait_until(lock, m_sleepsUntil = nextLook());
    }
}

// A message may be sent while this thread sleeps: it is due later than what is under way.
dxSimulatedNetwork::Clock::time_point dxSimulatedNetwork::nextLook() {
    const Clock::time_point now = Clock::now();
    if (m_isLooking || (m_state == State::Open && now - m_workerLooked < kLately)) return now + kBesideWorker;
    const Clock::time_point next = now + m_pause.next();
    return m_isLost || m_toCoordinator.messages.empty() ? next : std::min(next, m_toCoordinator.messages.front().due);
}
