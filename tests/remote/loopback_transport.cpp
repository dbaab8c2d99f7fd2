#include "loopback_transport.h"

#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "remote/worker/dxWorkRecord.h"

namespace {

constexpr std::size_t kDisconnected = 1;  // stands for the message that cannot be received

}  // namespace

dxRemoteHello helloOf(const char *version) {
    dxRemoteHello hello;
    std::snprintf(hello.version, sizeof hello.version, "%s", version);
    hello.realSize = 8;
    return hello;
}

struct LoopbackTransport::Worker final : dxRemoteTransport {
    unsigned links() const override { return 1; }

    bool send(unsigned, const void *message, std::size_t bytes) override {
        dxRemoteBytes copy(bytes);
        std::memcpy(copy.data(), message, bytes);
        const LoopbackFate one = fate ? fate(index, count++, static_cast<dxRemoteKind>(dxReadHeader(copy).kind)) : LoopbackFate();
        if (one.delay.count() > 0) std::this_thread::sleep_for(one.delay);
        if (one.kind == LoopbackFate::Kind::Dies) isDead = true;
        if (one.kind == LoopbackFate::Kind::Stopped) {
            while (!isClosed) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (isDead) return false;
        if (one.kind == LoopbackFate::Kind::Flipped) copy[one.bit / 8 % bytes] ^= std::byte{1} << one.bit % 8;
        const std::lock_guard<std::mutex> hold(toHome.mutex);
        toHome.messages.push_back(std::move(copy));
        return true;
    }
    std::size_t waiting(unsigned &link) override {
        const std::lock_guard<std::mutex> hold(toWorker.mutex);
        link = 0;
        if (!toWorker.messages.empty()) return toWorker.messages.front().size();
        return isClosed ? kDisconnected : 0;
    }
    bool receive(void *message) override {
        const std::lock_guard<std::mutex> hold(toWorker.mutex);
        if (toWorker.messages.empty()) return false;
        std::memcpy(message, toWorker.messages.front().data(), toWorker.messages.front().size());
        toWorker.messages.pop_front();
        return true;
    }
    void close(bool) override {}

    unsigned index = 0, count = 0;
    Fate fate;
    Queue toHome, toWorker;
    std::atomic<bool> isDead{false}, isClosed{false}, hasNoMemory{false};
    bool isReported = false;
    std::thread thread;
};

namespace {

// For whoever owns what it uses.
struct Borrowed final : dxRemoteTransport {
    explicit Borrowed(dxRemoteTransport &used) : transport(used) {}
    unsigned links() const override { return transport.links(); }
    bool isForAllThreads() const override { return true; }
    bool send(unsigned link, const void *message, std::size_t bytes) override { return transport.send(link, message, bytes); }
    std::size_t waiting(unsigned &link) override { return transport.waiting(link); }
    bool receive(void *message) override { return transport.receive(message); }
    void close(bool isOrderly) override { transport.close(isOrderly); }

    dxRemoteTransport &transport;
};

dxRemoteServer::End serve(dxRemoteTransport &end, const dxRemoteHello &hello, dxRemoteServer::Solve solve, const dxWorkerArguments &arguments) {
    constexpr double kMaxSilence = 5;
    std::string reason;
    std::unique_ptr<dxSimulatedNetwork> network;
    if (arguments.link.isThere())
        network = dxSimulatedNetwork::open(arguments.link, [&end](std::string &) { return std::make_unique<Borrowed>(end); }, reason);
    dxRemoteTransport &used = network ? *network : end;
    std::unique_ptr<dxWorkRecord> record;
    if (!arguments.record.empty()) record = dxWorkRecord::open(arguments.record, used, reason);
    if (record) solve = record->timed(std::move(solve));
    if (network) solve = network->carrying(std::move(solve));
    const dxRemoteServer::End how = dxRemoteServer(record ? *record : used, hello, std::move(solve)).run(kMaxSilence);
    used.close(true);
    return how;
}

}  // namespace

LoopbackTransport::LoopbackTransport(unsigned workers, const dxRemoteHello &hello, dxRemoteServer::Solve solve, Fate fate,
                                     const dxWorkerArguments &arguments)
    : m_hello(hello), m_solve(std::move(solve)), m_fate(std::move(fate)), m_arguments(arguments) {
    try {
        for (unsigned i = 0; i < workers; ++i) {
            m_workers.push_back(std::make_unique<Worker>());
            start(*m_workers.back(), i);
        }
    } catch (...) {
        endWorkers();
        throw;
    }
}

void LoopbackTransport::start(Worker &worker, unsigned index) {
    worker.index = index;
    worker.fate = m_fate;
    worker.thread = std::thread([this, &worker] {
        try {
            worker.hasNoMemory = serve(worker, m_hello, m_solve, m_arguments) == dxRemoteServer::End::NoMemory;
        } catch (const std::bad_alloc &) {
            worker.hasNoMemory = true;
        }
    });
}

LoopbackTransport::~LoopbackTransport() { endWorkers(); }

void LoopbackTransport::replace(unsigned link) {
    m_replaced.push_back(std::exchange(m_workers[link], std::make_unique<Worker>()));
    m_replacedLink = link;
}

dxRemoteTransport::Replacement LoopbackTransport::replacement() {
    start(*m_workers[m_replacedLink], m_replacedLink);
    return Replacement::Here;
}

void LoopbackTransport::endWorkers() {
    for (const auto *workers : {&m_workers, &m_replaced})
        for (const std::unique_ptr<Worker> &worker : *workers) worker->isClosed = true;
    for (const auto *workers : {&m_workers, &m_replaced})
        for (const std::unique_ptr<Worker> &worker : *workers)
            if (worker->thread.joinable()) worker->thread.join();
}

bool LoopbackTransport::send(unsigned link, const void *message, std::size_t bytes) {
    Worker &worker = *m_workers[link];
    if (worker.isDead) return false;
    dxRemoteBytes copy(bytes);
    std::memcpy(copy.data(), message, bytes);
    const std::lock_guard<std::mutex> hold(worker.toWorker.mutex);
    worker.toWorker.messages.push_back(std::move(copy));
    return true;
}

std::size_t LoopbackTransport::waiting(unsigned &link) {
    for (unsigned i = 0; i < links(); ++i) {
        const unsigned one = (m_next + i) % links();
        Worker &worker = *m_workers[one];
        const std::lock_guard<std::mutex> hold(worker.toHome.mutex);
        const bool isGone = worker.toHome.messages.empty();
        if (isGone && (!worker.hasNoMemory || std::exchange(worker.isReported, true))) continue;
        m_message.clear();
        if (!isGone) {
            m_message = std::move(worker.toHome.messages.front());
            worker.toHome.messages.pop_front();
        }
        m_next = one + 1;
        link = one;
        return isGone ? kDisconnected : m_message.size();
    }
    return 0;
}

bool LoopbackTransport::receive(void *message) {
    if (m_message.empty()) return false;
    std::memcpy(message, m_message.data(), m_message.size());
    return true;
}

// The destructor ends workers, those that are held back, too.
void LoopbackTransport::close(bool) {}
