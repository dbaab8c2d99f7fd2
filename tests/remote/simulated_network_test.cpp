// The simulated network delays as it is told: one message, several on a busy link, both directions at a time, and while its worker does something
// else; over a transport that one thread uses, and over one that all may use.
#include "remote/worker/dxSimulatedNetwork.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

double msSince(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

// Home, as the transport below sees it.
struct Home {
    struct Arrived {
        dxRemoteBytes bytes;
        Clock::time_point time;
        std::thread::id thread;
    };

    explicit Home(bool forAllThreads) : isForAllThreads(forAllThreads) {}

    void send(std::size_t bytes, int first = 0) {
        const std::lock_guard<std::mutex> hold(mutex);
        dxRemoteBytes message(bytes);
        message[0] = std::byte(first);
        toWorker.push_back(std::move(message));
    }
    std::size_t count() {
        const std::lock_guard<std::mutex> hold(mutex);
        return arrived.size();
    }
    void waitFor(std::size_t messages) {
        while (count() < messages) std::this_thread::sleep_for(100us);
    }
    bool isUsedByOneThread() {
        const std::lock_guard<std::mutex> hold(mutex);
        return isOneThread;
    }
    double msOf(std::size_t message, Clock::time_point begin) {
        return std::chrono::duration<double, std::milli>(arrived[message].time - begin).count();
    }

    const bool isForAllThreads;
    std::mutex mutex;
    std::deque<dxRemoteBytes> toWorker;
    std::vector<Arrived> arrived;
    std::thread::id thread;
    bool isOneThread = true;
    std::atomic<int> closed{0};  // 1: in good order, 2: not
    std::atomic<bool> isLost{false};
};

struct Below final : dxRemoteTransport {
    explicit Below(Home &other) : home(other) { home.thread = std::this_thread::get_id(); }
    unsigned links() const override { return 1; }
    bool isForAllThreads() const override { return home.isForAllThreads; }
    bool send(unsigned, const void *message, std::size_t bytes) override {
        const auto *const from = static_cast<const std::byte *>(message);
        const std::lock_guard<std::mutex> hold(home.mutex);
        noteThread();
        home.arrived.push_back({{from, from + bytes}, Clock::now(), std::this_thread::get_id()});
        return !home.isLost;
    }
    std::size_t waiting(unsigned &) override {
        const std::lock_guard<std::mutex> hold(home.mutex);
        noteThread();
        return home.toWorker.empty() ? 0 : home.toWorker.front().size();
    }
    bool receive(void *message) override {
        const std::lock_guard<std::mutex> hold(home.mutex);
        std::copy(home.toWorker.front().begin(), home.toWorker.front().end(), static_cast<std::byte *>(message));
        home.toWorker.pop_front();
        return true;
    }
    void close(bool isOrderly) override {
        noteThread();
        home.closed = isOrderly ? 1 : 2;
    }
    void noteThread() { home.isOneThread &= home.thread == std::this_thread::get_id(); }

    Home &home;
};

std::unique_ptr<dxSimulatedNetwork> openTo(Home &home, double delayMs, double nsPerByte) {
    std::string reason;
    return dxSimulatedNetwork::open({delayMs * 1e6, nsPerByte}, [&home](std::string &) { return std::make_unique<Below>(home); }, reason);
}

int receive(dxSimulatedNetwork &network) {
    unsigned link = 1;
    std::size_t bytes;
    while ((bytes = network.waiting(link)) == 0) std::this_thread::sleep_for(20us);
    EXPECT_EQ(link, 0u);
    dxRemoteBytes message(bytes);
    EXPECT_TRUE(network.receive(message.data()));
    return static_cast<int>(message[0]);
}

// A loaded machine delays as well: what has an upper bound has to be seen once.
constexpr double kLateMs = 3;

template <class Try>
bool comesTrue(const Try &isTrue) {
    const Clock::time_point end = Clock::now() + 60s;
    while (Clock::now() < end)
        if (isTrue()) return true;
    return false;
}

class SimulatedNetwork : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Transport, SimulatedNetwork, testing::Bool(),
                         [](const auto &info) { return info.param ? "ForAllThreads" : "ForOneThread"; });

TEST_P(SimulatedNetwork, AMessageArrivesAfterItsDelay) {
    Home home(GetParam());
    const auto network = openTo(home, 20, 0);
    EXPECT_TRUE(comesTrue([&] {
        const std::size_t number = home.count();
        const Clock::time_point begin = Clock::now();
        network->send(0, "x", 1);
        home.waitFor(number + 1);
        EXPECT_GE(home.msOf(number, begin), 20);
        return home.msOf(number, begin) <= 20 + kLateMs;
    }));
    // It is not known when it was sent, but for some microseconds where the network's thread looks in time.
    EXPECT_TRUE(comesTrue([&] {
        const Clock::time_point begin = Clock::now();
        home.send(1);
        receive(*network);
        const double passed = msSince(begin);
        return passed >= 19 && passed <= 20 + kLateMs;
    }));
}

// Three messages of 10 ms: the delay is waited for once, the link three times, and by the link, not by the worker.
TEST_P(SimulatedNetwork, ALinkIsBusyForTheBytes) {
    constexpr std::size_t kBytes = 10000;
    Home home(GetParam());
    const auto network = openTo(home, 20, 1000);
    const std::vector<char> message(kBytes);
    EXPECT_TRUE(comesTrue([&] {
        const std::size_t first = home.count();
        const Clock::time_point begin = Clock::now();
        for (int k = 0; k < 3; ++k) network->send(0, message.data(), message.size());
        const bool isSentAtOnce = msSince(begin) < 10;
        home.waitFor(first + 3);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(home.msOf(first + k, begin), 30 + 10 * static_cast<double>(k));
        return isSentAtOnce && home.msOf(first + 2, begin) <= 50 + kLateMs;
    }));
}

// What goes the other way does not wait, nor what arrives while the worker's thread is elsewhere; messages keep their order.
TEST_P(SimulatedNetwork, DirectionsDoNotWaitForOneAnother) {
    const std::vector<char> message(100000);  // 100 ms
    EXPECT_TRUE(comesTrue([&] {
        Home home(GetParam());
        const auto network = openTo(home, 1, 1000);
        const Clock::time_point begin = Clock::now();
        network->send(0, message.data(), message.size());
        for (int i = 0; i < 10; ++i) home.send(1000, i);
        std::this_thread::sleep_for(30ms);
        for (int i = 0; i < 10; ++i) EXPECT_EQ(receive(*network), i);
        const bool isFirst = home.count() == 0 && msSince(begin) < 100;
        home.waitFor(1);
        EXPECT_GE(home.msOf(0, begin), 101);
        return isFirst;
    }));
}

// What is due goes out while the worker solves, and right after it, by the worker's thread where that may.
TEST_P(SimulatedNetwork, NoMessageWaitsForAProblem) {
    Home home(GetParam());
    const auto network = openTo(home, 20, 0);
    const auto solve = network->carrying([](const std::byte *, std::size_t bytes, dxRemoteBytes &) {
        std::this_thread::sleep_for(std::chrono::milliseconds(bytes));
    });
    dxRemoteBytes result;
    const auto sendAndSolve = [&](std::size_t ms) {
        const Clock::time_point begin = Clock::now();
        network->send(0, "x", 1);
        solve(nullptr, ms, result);
        return begin;
    };
    EXPECT_TRUE(comesTrue([&] {
        const std::size_t number = home.count();
        const Clock::time_point begin = sendAndSolve(100);
        home.waitFor(number + 1);
        EXPECT_GE(home.msOf(number, begin), 20);
        return home.msOf(number, begin) <= 20 + kLateMs;
    }));
    EXPECT_TRUE(comesTrue([&] {
        const std::size_t number = home.count();
        const Clock::time_point begin = Clock::now();
        network->send(0, "x", 1);
        while (home.count() == number && msSince(begin) < 1000) solve(nullptr, 0, result);
        return !home.isForAllThreads || home.arrived[number].thread == std::this_thread::get_id();
    }));
    EXPECT_EQ(home.isUsedByOneThread(), !home.isForAllThreads);
}

TEST_P(SimulatedNetwork, KeepsNoCoreBusy) {
    Home home(GetParam());
    const auto network = openTo(home, 300, 0);
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    network->send(0, "x", 1);
    std::this_thread::sleep_for(290ms);
    getrusage(RUSAGE_SELF, &after);
    const auto ms = [](const rusage &usage) {
        return 1e3 * static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
               1e-3 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    };
    EXPECT_LT(ms(after) - ms(before), 100);
    home.waitFor(1);
}

TEST_P(SimulatedNetwork, WhatWasSentIsPassedOnBeforeItCloses) {
    Home home(GetParam());
    auto network = openTo(home, 30, 0);
    network->send(0, "x", 1);
    network->close(true);
    EXPECT_EQ(home.count(), 1u);
    EXPECT_EQ(home.closed, 1);
    EXPECT_TRUE(home.isOneThread);
}

TEST_P(SimulatedNetwork, ALostLinkIsReported) {
    Home home(GetParam());
    home.isLost = true;
    auto network = openTo(home, 1, 0);
    EXPECT_TRUE(network->send(0, "x", 1));
    home.waitFor(1);
    const Clock::time_point begin = Clock::now();
    while (network->send(0, "x", 1) && msSince(begin) < 5000) std::this_thread::sleep_for(1ms);
    EXPECT_FALSE(network->send(0, "x", 1));
    network.reset();
    EXPECT_EQ(home.closed, 2);
}

TEST(SimulatedNetworkTest, WithoutATransportThereIsNone) {
    std::string reason;
    EXPECT_EQ(dxSimulatedNetwork::open({1, 0}, [](std::string &why) { why = "none"; return std::unique_ptr<dxRemoteTransport>(); }, reason), nullptr);
    EXPECT_EQ(reason, "none");
}

}  // namespace
