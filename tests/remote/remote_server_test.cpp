// How often a worker looks for messages: seldom when it has heard nothing for a while, whatever signs of life home gives, and often again when
// problems are about to come.
#include "remote/worker/dxRemoteServer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>

#include "remote/transport/dxPollPause.h"

namespace {

// Counts looks.
class CountingTransport final : public dxRemoteTransport {
public:
    unsigned links() const override { return 1; }
    bool send(unsigned, const void *, std::size_t) override { return true; }
    std::size_t waiting(unsigned &link) override {
        ++looks;
        link = 0;
        const std::lock_guard<std::mutex> hold(m_mutex);
        return m_messages.empty() ? 0 : m_messages.front().size();
    }
    bool receive(void *message) override {
        const std::lock_guard<std::mutex> hold(m_mutex);
        std::memcpy(message, m_messages.front().data(), m_messages.front().size());
        m_messages.pop_front();
        return true;
    }
    void close(bool) override {}

    void put(dxRemoteKind kind) {
        const std::lock_guard<std::mutex> hold(m_mutex);
        m_messages.push_back(dxRemoteFrame().seal(kind));
    }

    std::atomic<unsigned> looks{0};

private:
    std::mutex m_mutex;
    std::deque<dxRemoteBytes> m_messages;
};

// A loaded machine makes pauses longer, never shorter.
TEST(RemoteServer, SleepsUntilItIsToldThatProblemsCome) {
    CountingTransport transport;
    dxRemoteServer server(transport, {}, [](const std::byte *, std::size_t, dxRemoteBytes &) {});
    std::thread worker([&server] { EXPECT_EQ(server.run(60), dxRemoteServer::End::Disorderly); });
    const auto looksIn = [&transport](std::chrono::milliseconds time) {
        const unsigned before = transport.looks;
        std::this_thread::sleep_for(time);
        return transport.looks - before;
    };
    constexpr std::chrono::milliseconds kMoment(300);
    while (looksIn(kMoment) > 300000000 / dxPollPause::longestNs(2e9) + 10) continue;
    transport.put(dxRemoteKind::Alive);
    const unsigned asleep = looksIn(kMoment);
    unsigned awake = 0;
    for (int attempt = 0; attempt < 20 && awake < 2 * asleep; ++attempt) {
        transport.put(dxRemoteKind::Wake);
        awake = looksIn(kMoment);
    }
    EXPECT_LE(asleep, 300000000 / dxPollPause::longestNs(2e9) + 10) << "a sign of life wakes nobody";
    EXPECT_GE(awake, 2 * asleep);
    transport.put(dxRemoteKind::Quit);
    worker.join();
}

}  // namespace
