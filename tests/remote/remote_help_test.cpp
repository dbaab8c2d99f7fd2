// Home's threads carry messages between two problems: one at a time, only where the transport allows it, and whatever its calls do.
#include "remote/dxRemoteWorkers.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "loopback_transport.h"

namespace {

void solve(const std::byte *problem, std::size_t size, dxRemoteBytes &result) { result.assign(problem, problem + size); }

dxRemoteHello hello() {
    dxRemoteHello hello;
    std::strcpy(hello.version, "1");
    hello.realSize = 8;
    return hello;
}

// What a transport was told, by whom.
struct Calls {
    std::atomic<int> now{0}, mostAtATime{0};
    std::mutex mutex;
    std::set<std::thread::id> threads;

    std::size_t countThreads() {
        const std::lock_guard<std::mutex> hold(mutex);
        return threads.size();
    }
    bool areOf(std::thread::id thread) {
        const std::lock_guard<std::mutex> hold(mutex);
        return threads.count(thread) != 0;
    }
};

class Call {
public:
    explicit Call(Calls &calls) : m_calls(calls) {
        const int now = ++calls.now;
        if (now > calls.mostAtATime) calls.mostAtATime = now;
        const std::lock_guard<std::mutex> hold(calls.mutex);
        calls.threads.insert(std::this_thread::get_id());
    }
    ~Call() { --m_calls.now; }

private:
    Calls &m_calls;
};

class WatchedTransport final : public dxRemoteTransport {
public:
    WatchedTransport(unsigned workers, Calls &calls, bool isForAllThreads, std::thread::id faulty)
        : m_below(workers, hello(), solve), m_calls(calls), m_isForAllThreads(isForAllThreads), m_faulty(faulty) {}

    unsigned links() const override { return m_below.links(); }
    bool isForAllThreads() const override { return m_isForAllThreads; }
    bool send(unsigned link, const void *message, std::size_t bytes) override {
        const Call call(m_calls);
        pthread_testcancel();
        if (std::this_thread::get_id() == m_faulty) throw std::runtime_error("a fault");
        return m_below.send(link, message, bytes);
    }
    std::size_t waiting(unsigned &link) override {
        const Call call(m_calls);
        return m_below.waiting(link);
    }
    bool receive(void *message) override {
        const Call call(m_calls);
        return m_below.receive(message);
    }
    void close(bool isOrderly) override { m_below.close(isOrderly); }

private:
    LoopbackTransport m_below;
    Calls &m_calls;
    const bool m_isForAllThreads;
    const std::thread::id m_faulty;
};

class RemoteHelp : public testing::Test {
protected:
    ~RemoteHelp() override { m_workers.close(); }

    // `faulty`: a thread whose calls throw.
    void open(bool isForAllThreads, std::thread::id faulty = {}) {
        m_workers.open("loopback", hello(), [=](std::string &) { return std::make_unique<WatchedTransport>(2, m_calls, isForAllThreads, faulty); });
        ASSERT_EQ(m_workers.capacity().workers, 2u);
    }

    // A step of so many problems, of which home solves what it is given. Returns those that have come back right.
    unsigned step(unsigned count, bool mayHurry = true) {
        dxRemoteBatch batch(m_workers, count, mayHurry);
        for (unsigned i = 0; i < count; ++i) batch.submit(i, problemOf(i), 100e3);
        unsigned index = 0, right = 0;
        dxRemoteBytes result;
        for (dxRemoteBatch::Next next; (next = batch.next(index, result)) != dxRemoteBatch::Next::None; m_workers.help())
            right += next == dxRemoteBatch::Next::AtHome || result == problemOf(index);
        return right;
    }

    static dxRemoteBytes problemOf(unsigned index) { return dxRemoteBytes(500 + index, std::byte(index)); }

    dxRemoteWorkers &m_workers = dxRemoteWorkers::instance();
    Calls m_calls;
};

TEST_F(RemoteHelp, IsGivenByTheThreadThatSteps) {
    open(true);
    EXPECT_EQ(step(100, false), 100u);
    EXPECT_TRUE(m_calls.areOf(std::this_thread::get_id()));
}

TEST_F(RemoteHelp, IsNotGivenWhereOneThreadHasToMakeAllCalls) {
    open(false);
    EXPECT_EQ(step(100, false), 100u);
    EXPECT_EQ(m_calls.countThreads(), 1u);
    EXPECT_FALSE(m_calls.areOf(std::this_thread::get_id()));
}

TEST_F(RemoteHelp, IsGivenByOneThreadAtATime) {
    constexpr unsigned kThreads = 4, kSteps = 50, kProblems = 30;
    open(true);
    std::atomic<unsigned> right{0};
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < kThreads; ++i)
        threads.emplace_back([&] {
            for (unsigned k = 0; k < kSteps; ++k) right += step(kProblems, k % 2 == 0);
        });
    for (std::thread &one : threads) one.join();
    EXPECT_EQ(right, kThreads * kSteps * kProblems);
    EXPECT_EQ(m_calls.mostAtATime, 1);
    EXPECT_GE(m_calls.countThreads(), 2u);
}

TEST_F(RemoteHelp, IsNoPlaceWhereAThreadIsCancelled) {
    open(true);
    unsigned right = 0;
    bool isThere = false;
    std::function<void()> stepping = [&] {
        pthread_cancel(pthread_self());
        right = step(50, false);
        isThere = m_calls.areOf(std::this_thread::get_id());
        pthread_testcancel();
    };
    const auto body = [](void *call) -> void * {
        (*static_cast<std::function<void()> *>(call))();
        return nullptr;
    };
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, nullptr, body, &stepping), 0);
    void *end = nullptr;
    pthread_join(thread, &end);
    EXPECT_EQ(end, PTHREAD_CANCELED);
    EXPECT_EQ(right, 50u);
    EXPECT_TRUE(isThere);
}

TEST_F(RemoteHelp, ThatThrowsLeavesTheStepAtHome) {
    open(true, std::this_thread::get_id());
    EXPECT_EQ(step(50), 50u);
    EXPECT_FALSE(m_workers.areThere());
    EXPECT_EQ(step(50), 50u);
}

}  // namespace
