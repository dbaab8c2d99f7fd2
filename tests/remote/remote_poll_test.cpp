// Threads that step worlds carry messages between two problems: one at a time, only where the transport allows it, and whatever its calls do.
//
// Covers dxRemoteMessenger.cpp.
#include "remote/coordinator/dxRemoteBatch.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "../frame/sanitizers.h"
#include "loopback_transport.h"

namespace {

void solve(const std::byte *problem, std::size_t size, dxRemoteBytes &result) { result.assign(problem, problem + size); }

// What a transport was told, by whom.
struct Calls {
    std::atomic<int> now{0}, mostAtATime{0};
    std::function<void()> disturb;  // in each of them that sends; before there are any
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
    WatchedTransport(unsigned workers, Calls &calls, bool isForAllThreads, std::thread::id faulty, LoopbackTransport::Fate fate)
        : m_below(workers, helloOf("1"), solve, fate), m_calls(calls), m_isForAllThreads(isForAllThreads), m_faulty(faulty) {
        if (fate) m_below.setReplacing();
    }

    unsigned links() const override { return m_below.links(); }
    bool isForAllThreads() const override { return m_isForAllThreads; }
    bool send(unsigned link, const void *message, std::size_t bytes) override {
        const Call call(m_calls);
        pthread_testcancel();
        if (m_calls.disturb) m_calls.disturb();
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
    bool canReplace() const override { return m_below.canReplace(); }
    void replace(unsigned link) override {
        const Call call(m_calls);
        m_below.replace(link);
    }
    Replacement replacement() override {
        const Call call(m_calls);
        return m_below.replacement();
    }
    void close(bool isOrderly) override { m_below.close(isOrderly); }

private:
    LoopbackTransport m_below;
    Calls &m_calls;
    const bool m_isForAllThreads;
    const std::thread::id m_faulty;
};

class RemotePoll : public testing::Test {
protected:
    ~RemotePoll() override { m_workers.close(); }

    // `faulty`: a thread whose calls throw. `fate`: of workers, which are replaced.
    void open(bool isForAllThreads, std::thread::id faulty = {}, const LoopbackTransport::Fate &fate = nullptr) {
        m_workers.open("loopback", helloOf("1"),
                       [=](std::string &) { return std::make_unique<WatchedTransport>(2, m_calls, isForAllThreads, faulty, fate); });
        ASSERT_EQ(m_workers.capacity().workers, 2u);
    }

    // A step of `count` problems, of which this process solves what it is given. Returns those that have come back right.
    unsigned step(unsigned count, bool mayReclaim = true) {
        dxRemoteBatch batch(m_workers, count, mayReclaim);
        for (unsigned i = 0; i < count; ++i) batch.submit(i, problemOf(i), 100e3);
        unsigned index = 0, right = 0;
        dxRemoteBytes result;
        for (dxRemoteBatch::Next next; (next = batch.next(index, result)) != dxRemoteBatch::Next::None; m_workers.poll())
            right += next == dxRemoteBatch::Next::Reclaimed || result == problemOf(index);
        return right;
    }

    // Until the handler of a signal has forked. Both go on, the child without workers.
    void stepInBoth();

    // Of calls, while four threads make `steps` steps each.
    void expectOneAtATime(unsigned steps) {
        constexpr unsigned kThreads = 4, kProblems = 30;
        std::atomic<unsigned> right{0};
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < kThreads; ++i)
            threads.emplace_back([&] {
                for (unsigned k = 0; k < steps; ++k) right += step(kProblems, k % 2 == 0);
            });
        for (std::thread &one : threads) one.join();
        EXPECT_EQ(right, kThreads * steps * kProblems);
        EXPECT_EQ(m_calls.mostAtATime, 1);
    }

    static dxRemoteBytes problemOf(unsigned index) { return dxRemoteBytes(500 + index, std::byte(index)); }

    dxRemoteWorkers &m_workers = dxRemoteWorkers::instance();
    Calls m_calls;
};

// Both workers have one when the second problem has been submitted, and none waits for the next look of this thread's. Now and then the
// communication thread has the turn at that moment, on a loaded machine often; of looks every 60 us none or a few would come in time.
TEST_F(RemotePoll, AWorkerWithNothingToDoGetsAProblemAtOnce) {
    constexpr unsigned kSteps = 100;
    open(true);
    unsigned atOnce = 0;
    for (unsigned i = 0; i < kSteps; ++i) {
        const std::uint64_t before = m_workers.counts().sent;
        dxRemoteBatch batch(m_workers, 2, false);
        for (unsigned k = 0; k < 2; ++k) batch.submit(k, problemOf(k), 100e3);
        atOnce += m_workers.counts().sent == before + 2;
        unsigned index = 0;
        dxRemoteBytes result;
        while (batch.next(index, result) != dxRemoteBatch::Next::None) continue;
    }
    EXPECT_GT(atOnce, kSteps / 5);
}

TEST_F(RemotePoll, IsDoneByTheThreadThatSteps) {
    open(true);
    EXPECT_EQ(step(100, false), 100u);
    EXPECT_TRUE(m_calls.areOf(std::this_thread::get_id()));
}

TEST_F(RemotePoll, IsNotDoneWhereOneThreadHasToMakeAllCalls) {
    open(false);
    EXPECT_EQ(step(100, false), 100u);
    EXPECT_EQ(m_calls.countThreads(), 1u);
    EXPECT_FALSE(m_calls.areOf(std::this_thread::get_id()));
}

TEST_F(RemotePoll, IsDoneByOneThreadAtATime) {
    open(true);
    expectOneAtATime(50);
    EXPECT_GE(m_calls.countThreads(), 2u);
}

TEST_F(RemotePoll, WaitsWhileWorkersAreReplaced) {
    m_calls.disturb = [] { std::this_thread::sleep_for(std::chrono::microseconds(200)); };
    const unsigned replaced = m_workers.counts().replaced;
    open(true, {}, [](unsigned worker, unsigned count, dxRemoteKind) {
        LoopbackFate fate;
        if (worker == 0 && count == 10) fate.kind = LoopbackFate::Kind::Dies;
        return fate;
    });
    for (int rounds = 0; rounds < 500 && m_workers.counts().replaced == replaced; ++rounds) expectOneAtATime(5);
    EXPECT_GT(m_workers.counts().replaced, replaced);
}

TEST_F(RemotePoll, IsNoPlaceWhereAThreadIsCancelled) {
    if (kAddressSanitizer) GTEST_SKIP() << "AddressSanitizer does not bear the end of a cancelled thread";
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

// Each call of the transport's that sends raises this signal for its own thread: the stepping one, or the other one, which has signals blocked.
class RaisedSignal {
public:
    RaisedSignal(Calls &calls, int signal, void (*handle)(int)) : m_signal(signal) {
        struct sigaction handler {};
        handler.sa_handler = handle;
        sigaction(signal, &handler, &m_before);
        calls.disturb = [signal] { pthread_kill(pthread_self(), signal); };
    }
    ~RaisedSignal() { sigaction(m_signal, &m_before, nullptr); }

private:
    const int m_signal;
    struct sigaction m_before;
};

// As a call that writes to a worker which has ended.
TEST_F(RemotePoll, RaisesNoSignal) {
    static std::atomic<int> signals{0};
    const RaisedSignal raised(m_calls, SIGPIPE, [](int) { ++signals; });
    open(true);
    errno = 0;
    EXPECT_EQ(step(50, false), 50u);
    EXPECT_TRUE(m_calls.areOf(std::this_thread::get_id()));
    EXPECT_EQ(signals, 0);
    m_workers.close();
    raise(SIGPIPE);
    EXPECT_EQ(signals, 1) << "the program's own arrives";
}

TEST_F(RemotePoll, LeavesErrnoAndTheSignalMaskAsTheyAre) {
    m_calls.disturb = [] { errno = EPIPE; };
    open(true);
    sigset_t before, after;
    pthread_sigmask(SIG_SETMASK, nullptr, &before);
    errno = 0;
    EXPECT_EQ(step(50, false), 50u);
    EXPECT_EQ(errno, 0);
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    for (int signal = 1; signal < NSIG; ++signal) EXPECT_EQ(sigismember(&before, signal), sigismember(&after, signal)) << signal;
}

// One that was blocked and pending before stays so.
TEST_F(RemotePoll, LeavesTheProgramItsPendingSignal) {
    sigset_t pipe, pending;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    raise(SIGPIPE);
    open(true);
    EXPECT_EQ(step(50, false), 50u);
    sigpending(&pending);
    EXPECT_EQ(sigismember(&pending, SIGPIPE), 1);
    const timespec now{};
    EXPECT_EQ(sigtimedwait(&pipe, nullptr, &now), SIGPIPE);
    pthread_sigmask(SIG_UNBLOCK, &pipe, nullptr);
}

// As exit() does, which closes them.
TEST_F(RemotePoll, LetsHandlersUseTheWorkers) {
    static std::atomic<unsigned> handled{0};
    const RaisedSignal raised(m_calls, SIGUSR1, [](int) { handled += dxRemoteWorkers::instance().capacity().workers; });
    open(true);
    for (int steps = 0; steps < 200 && handled == 0; ++steps) EXPECT_EQ(step(50, false), 50u);
    EXPECT_GE(handled, 2u);
}

pid_t childOfHandler;

void forkInHandler(int) {
    const int error = errno;
    if (childOfHandler < 0) childOfHandler = fork();
    if (childOfHandler == 0) alarm(60);
    errno = error;
}

void RemotePoll::stepInBoth() {
    unsigned right = 50;
    for (int steps = 0; steps < 200 && childOfHandler < 0; ++steps) right = std::min(right, step(50, false));
    if (childOfHandler == 0) _exit(right == 50 && step(50) == 50 && !m_workers.areThere() && m_workers.capacity().workers == 0 ? 0 : 1);
    ASSERT_GT(childOfHandler, 0);
    int status = 0;
    waitpid(childOfHandler, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(right, 50u);
}

// The child goes on with the step, alone.
TEST_F(RemotePoll, IsNotDoneByTheChildOfAHandlerThatForks) {
    if (kAddressSanitizer) GTEST_SKIP() << "another thread may hold a lock of AddressSanitizer's, which the child would wait for";
    childOfHandler = -1;
    const RaisedSignal raised(m_calls, SIGUSR1, forkInHandler);
    open(true);
    stepInBoth();
}

TEST_F(RemotePoll, IsNotWaitedForByTheChildOfAHandlerThatForks) {
    if (kAddressSanitizer) GTEST_SKIP() << "another thread may hold a lock of AddressSanitizer's, which the child would wait for";
    childOfHandler = -1;
    const RaisedSignal raised(m_calls, SIGUSR1, forkInHandler);
    std::atomic<bool> isOver{false}, isWaiting{false};
    m_calls.disturb = [&] { isWaiting = true; };
    open(false, {}, [&](unsigned, unsigned, dxRemoteKind kind) {
        LoopbackFate fate;
        if (kind == dxRemoteKind::Results) fate.delay = std::chrono::milliseconds(100);
        return fate;
    });
    isWaiting = false;
    std::thread other([&, stepping = pthread_self()] {
        while (!isWaiting && !isOver) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        pthread_kill(stepping, SIGUSR1);
    });
    stepInBoth();
    isOver = true;
    other.join();
}

// Whoever holds the lock at that moment gives it back first.
TEST_F(RemotePoll, DoesNotDisturbChildrenOfOtherThreads) {
    if (kAddressSanitizer) GTEST_SKIP() << "another thread may hold a lock of AddressSanitizer's, which the child would wait for";
    open(true);
    std::atomic<bool> isOver{false};
    std::thread stepping([&] {
        while (!isOver) EXPECT_EQ(step(50), 50u);
    });
    for (int i = 0; i < 200; ++i) {
        const pid_t child = fork();
        if (child == 0) _exit(m_workers.areThere() ? 1 : 0);
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    isOver = true;
    stepping.join();
}

TEST_F(RemotePoll, ThatThrowsLeavesTheStepInThisProcess) {
    open(true, std::this_thread::get_id());
    for (int steps = 0; steps < 200 && m_workers.areThere(); ++steps) EXPECT_EQ(step(50), 50u);  // the other thread may be faster
    EXPECT_FALSE(m_workers.areThere());
    EXPECT_EQ(step(50), 50u);
}

}  // namespace
