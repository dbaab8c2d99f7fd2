// Batches come back whole and right, whatever becomes of workers: a thousand times one dies, stops, or sends flipped bits.
//
// Covers dxRemoteBatch.cpp, dxRemoteMessenger.cpp, dxRemoteReplacement.cpp.
#include "remote/coordinator/dxRemoteBatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <memory>
#include <numeric>
#include <random>

#include "core/dxStopwatch.h"
#include "loopback_transport.h"

namespace {

using Clock = std::chrono::steady_clock;
using Kind = LoopbackFate::Kind;
constexpr double kProblemNs = 100e3;

// What stands for a solver: the sum of the bytes, after a while.
std::uint64_t sumOf(const std::byte *data, std::size_t size) {
    std::uint64_t sum = size;
    for (std::size_t i = 0; i < size; ++i) sum = sum * 31 + static_cast<std::uint64_t>(data[i]);
    return sum;
}

void solve(const std::byte *problem, std::size_t size, dxRemoteBytes &result) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    const std::uint64_t sum = sumOf(problem, size);
    result.resize(sizeof sum);
    std::memcpy(result.data(), &sum, sizeof sum);
}

dxRemoteBytes problemOf(unsigned index) { return dxRemoteBytes(1000 + 37 * index, std::byte(index)); }

class RemoteWorkers : public testing::Test {
protected:
    void open(unsigned workers, LoopbackTransport::Fate fate = nullptr, const char *version = "1") {
        m_workers.open("loopback", helloOf("1"), [=](std::string &) {
            return std::make_unique<LoopbackTransport>(workers, helloOf(version), solve, fate);
        });
    }
    ~RemoteWorkers() override { m_workers.close(); }

    // A worker whose results are delayed.
    void openDelayed(std::chrono::milliseconds delay) {
        open(1, [delay](unsigned, unsigned, dxRemoteKind kind) {
            LoopbackFate fate;
            if (kind == dxRemoteKind::Results) fate.delay = delay;
            return fate;
        });
    }

    // Until as many problems have been sent since the beginning, or for two seconds.
    void waitUntilSent(std::uint64_t count) {
        for (int attempt = 0; attempt < 400 && countsSince(m_before).sent < count; ++attempt)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }

    // Takes whatever comes, reclaimed problems unsolved.
    static void drain(dxRemoteBatch &batch) {
        unsigned index = 0;
        dxRemoteBytes result;
        while (batch.next(index, result) != dxRemoteBatch::Next::None) {}
    }

    // Returns how many of the problems were reclaimed. Waits for workers, unless it `mayReclaim`.
    unsigned runBatch(unsigned count, bool mayReclaim = true, double cost = kProblemNs) {
        dxRemoteBatch batch(m_workers, count, mayReclaim);
        for (unsigned i = 0; i < count; ++i) batch.submit(i, problemOf(i), cost);
        unsigned index = 0, reclaimed = 0, answered = 0;
        std::vector<bool> isAnswered(count);
        dxRemoteBytes result;
        for (dxRemoteBatch::Next next; (next = batch.next(index, result)) != dxRemoteBatch::Next::None; ++answered) {
            EXPECT_FALSE(isAnswered[index]) << index;
            isAnswered[index] = true;
            const dxRemoteBytes problem = problemOf(index);
            if (next == dxRemoteBatch::Next::Reclaimed) {
                ++reclaimed;
                solve(problem.data(), problem.size(), result);
                continue;
            }
            std::uint64_t sum = 0;
            EXPECT_EQ(result.size(), sizeof sum);
            std::memcpy(&sum, result.data(), std::min(result.size(), sizeof sum));
            EXPECT_EQ(sum, sumOf(problem.data(), problem.size()));
        }
        EXPECT_EQ(answered, count);
        EXPECT_EQ(batch.outcomes().solved(), count - reclaimed);
        EXPECT_LE(batch.outcomes().returned(), reclaimed);
        return reclaimed;
    }

    // What has happened since.
    dxRemoteWorkers::Counts countsSince(const dxRemoteWorkers::Counts &before) {
        dxRemoteWorkers::Counts counts = m_workers.counts();
        counts.sent -= before.sent;
        counts.late -= before.late;
        counts.refused -= before.refused;
        counts.lost -= before.lost;
        for (int i = 0; i < static_cast<int>(dxRemoteOutcome::Count); ++i)
            counts.outcomes[static_cast<dxRemoteOutcome>(i)] -= before.outcomes[static_cast<dxRemoteOutcome>(i)];
        return counts;
    }

    // Whether `workers` workers are usable within a second.
    bool hasSoon(unsigned workers) {
        for (int attempt = 0; attempt < 200 && m_workers.capacity().workers != workers; ++attempt)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return m_workers.capacity().workers == workers;
    }

    dxRemoteWorkers &m_workers = dxRemoteWorkers::instance();
    const dxRemoteWorkers::Counts m_before = m_workers.counts();
};

TEST_F(RemoteWorkers, SolveAllThatIsWaitedFor) {
    open(3);
    ASSERT_TRUE(m_workers.areThere());
    EXPECT_EQ(m_workers.capacity().workers, 3u);
    EXPECT_EQ(runBatch(100, false), 0u);
}

TEST_F(RemoteWorkers, ShareWithThisProcess) {
    openDelayed(std::chrono::milliseconds(10));  // this process comes to solve, however slowly it submits
    const unsigned reclaimed = runBatch(200);
    EXPECT_GT(reclaimed, 0u);
    EXPECT_LT(reclaimed, 200u);
}

TEST_F(RemoteWorkers, OfAnotherVersionAreRefused) {
    open(2, nullptr, "2");
    EXPECT_FALSE(m_workers.areThere());
    EXPECT_EQ(runBatch(10), 10u);
    EXPECT_EQ(countsSince(m_before).refused, 2u);
    EXPECT_EQ(countsSince(m_before).lost, 0u);
    EXPECT_EQ(countsSince(m_before).sent, 0u);
}

// As a worker that ends before it joins may make MPI wait for ever. What begins too late is ended by the communication thread.
TEST_F(RemoteWorkers, ThatDoNotBeginAreNotWaitedFor) {
    std::promise<void> begin;
    auto owned = std::make_shared<int>(0);
    const std::weak_ptr<int> transport = owned;
    auto open = [owned = std::move(owned), gate = begin.get_future().share()](std::string &) mutable {
        gate.wait();
        return std::make_unique<LoopbackTransport>(1, helloOf("1"), solve, [owned = std::move(owned)](unsigned, unsigned, dxRemoteKind) {
            return LoopbackFate{Kind::Arrives};
        });
    };
    testing::internal::CaptureStderr();
    m_workers.open("loopback", helloOf("1"), std::move(open), std::chrono::milliseconds(20));
    EXPECT_NE(testing::internal::GetCapturedStderr().find("none by loopback: it does not begin"), std::string::npos);
    EXPECT_FALSE(m_workers.areThere());
    EXPECT_EQ(runBatch(10), 10u);
    begin.set_value();
    for (int i = 0; i < 2000 && !transport.expired(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(transport.expired());
    EXPECT_FALSE(m_workers.areThere());
}

TEST_F(RemoteWorkers, FewerThanWantedAreTold) {
    testing::internal::CaptureStderr();
    m_workers.open("loopback", helloOf("1"), [](std::string &reason) {
        reason = "the second cannot be started";
        return std::make_unique<LoopbackTransport>(1, helloOf("1"), solve);
    });
    EXPECT_NE(testing::internal::GetCapturedStderr().find("1 by loopback, fewer than wanted: the second cannot be started"), std::string::npos);
}

TEST_F(RemoteWorkers, ThatStopDelayAStepByAFewMilliseconds) {
    open(1, [](unsigned, unsigned, dxRemoteKind kind) { return LoopbackFate{kind == dxRemoteKind::Results ? Kind::Stopped : Kind::Arrives}; });
    const dxStopwatch stopwatch;
    EXPECT_EQ(runBatch(40), 40u);
    EXPECT_LT(stopwatch.ns(), 1e9);
    EXPECT_TRUE(hasSoon(0));
    EXPECT_EQ(runBatch(4), 4u) << "nothing is sent to a worker that does not answer";
}

TEST_F(RemoteWorkers, ThatWereLateAreUsedAgain) {
    std::atomic<unsigned> slow{1};
    open(1, [&slow](unsigned, unsigned, dxRemoteKind kind) {
        LoopbackFate fate;
        if (kind == dxRemoteKind::Results && slow.exchange(0) == 1) fate.delay = std::chrono::milliseconds(50);
        return fate;
    });
    for (int attempt = 0; attempt < 20 && countsSince(m_before).late == 0; ++attempt) {
        runBatch(4);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(countsSince(m_before).late, 1u);
    EXPECT_TRUE(hasSoon(1));
    EXPECT_EQ(runBatch(20, false), 0u);
}

TEST_F(RemoteWorkers, CountWhatTheySolve) {
    open(3);
    runBatch(100, false);
    const dxRemoteWorkers::Counts counts = countsSince(m_before);
    EXPECT_EQ(counts.open, 3u);
    EXPECT_EQ(counts.openLate, 0u);
    EXPECT_EQ(counts.sent, 100u);
    EXPECT_EQ(counts.outcomes.solved(), 100u);
    EXPECT_EQ(counts.outcomes.returned(), 0u);
    m_workers.close();
    EXPECT_EQ(m_workers.counts().open, 0u);
}

// The first problem is waited for until its worker is late; a second one, which is under way behind that, is reclaimed before.
TEST_F(RemoteWorkers, CountWhatIsLate) {
    open(1, [](unsigned, unsigned, dxRemoteKind kind) { return LoopbackFate{kind == dxRemoteKind::Results ? Kind::Stopped : Kind::Arrives}; });
    constexpr double kLongNs = 100 * kProblemNs;
    for (int attempt = 0; attempt < 20 && countsSince(m_before).sent == 0; ++attempt) EXPECT_EQ(runBatch(20, true, kLongNs), 20u);
    const dxRemoteWorkers::Counts counts = countsSince(m_before);
    EXPECT_GT(counts.outcomes[dxRemoteOutcome::Late], 0u);
    EXPECT_EQ(counts.outcomes[dxRemoteOutcome::Late] + counts.outcomes[dxRemoteOutcome::Sooner], counts.sent);
    EXPECT_EQ(counts.outcomes.solved(), 0u);
    EXPECT_EQ(counts.late, 1u);
    EXPECT_EQ(counts.lost, 0u);
    EXPECT_EQ(counts.open, 1u);
    EXPECT_EQ(counts.openLate, 1u);
}

// This process has other things to do for longer than the worker was predicted to need.
TEST_F(RemoteWorkers, AreNotLateWhileThisProcessIsBusy) {
    openDelayed(std::chrono::milliseconds(30));
    dxRemoteBatch batch(m_workers, 2, true);
    for (unsigned i = 0; i < 2; ++i) batch.submit(i, problemOf(i), kProblemNs);
    waitUntilSent(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(countsSince(m_before).late, 0u);
    EXPECT_EQ(m_workers.capacity().workers, 1u);
    drain(batch);
    EXPECT_EQ(countsSince(m_before).late, 0u);
    EXPECT_GT(batch.outcomes().solved(), 0u);
}

// This process finds that its own problems take a thousand times what was predicted, and waits for the worker.
TEST_F(RemoteWorkers, AreGivenTheTimeThatProblemsTakeHere) {
    openDelayed(std::chrono::milliseconds(40));
    for (const bool isTold : {true, false}) {
        SCOPED_TRACE(isTold);
        dxRemoteBatch batch(m_workers, 1, true);
        batch.submit(0, problemOf(0), kProblemNs);
        waitUntilSent(isTold ? 1 : 2);
        if (isTold) batch.noteLocal(kProblemNs, 1000 * kProblemNs);
        drain(batch);
        EXPECT_EQ(batch.outcomes().solved(), isTold ? 1u : 0u);
        if (isTold) {
            EXPECT_EQ(countsSince(m_before).late, 0u);
        }
    }
}

// A message that takes so long to be answered is not worth waiting for.
TEST_F(RemoteWorkers, CountWhatIsSolvedSoonerHere) {
    open(1, [](unsigned, unsigned, dxRemoteKind kind) {
        LoopbackFate fate;
        if (kind == dxRemoteKind::Echo) fate.delay = std::chrono::milliseconds(50);
        return fate;
    });
    for (int attempt = 0; attempt < 20 && countsSince(m_before).outcomes[dxRemoteOutcome::Sooner] == 0; ++attempt) runBatch(20);
    const dxRemoteWorkers::Counts counts = countsSince(m_before);
    EXPECT_GT(counts.outcomes[dxRemoteOutcome::Sooner], 0u);
    EXPECT_EQ(counts.outcomes.solved() + counts.outcomes.returned(), counts.sent);
}

TEST_F(RemoteWorkers, CountWhatIsLostWithThem) {
    open(1, [](unsigned, unsigned, dxRemoteKind kind) {
        return LoopbackFate{kind == dxRemoteKind::Results ? Kind::Flipped : Kind::Arrives, {}, 300};
    });
    EXPECT_EQ(runBatch(4, false), 4u);
    const dxRemoteWorkers::Counts counts = countsSince(m_before);
    EXPECT_GT(counts.sent, 0u);
    EXPECT_EQ(counts.outcomes[dxRemoteOutcome::Lost], counts.sent);
    EXPECT_EQ(counts.outcomes.solved(), 0u);
    EXPECT_EQ(counts.lost, 1u);
    EXPECT_EQ(counts.open, 0u);
}

TEST_F(RemoteWorkers, SeveralStepsShareThem) {
    open(2);
    std::vector<std::thread> steps;
    for (int i = 0; i < 4; ++i)
        steps.emplace_back([this] {
            for (int batch = 0; batch < 10; ++batch) runBatch(20, batch % 2 == 0);
        });
    for (std::thread &step : steps) step.join();
}

TEST_F(RemoteWorkers, AStepThatEndsEarlyIsForgotten) {
    open(2);
    for (int i = 0; i < 50; ++i) {
        dxRemoteBatch batch(m_workers, 20, true);
        for (unsigned k = 0; k < 10; ++k) batch.submit(k, problemOf(k), kProblemNs);
    }
    // On a slow machine workers may be late with what was forgotten.
    unsigned reclaimed = 20;
    for (int attempt = 0; attempt < 10 && reclaimed > 0 && hasSoon(2); ++attempt) reclaimed = runBatch(20, false);
    EXPECT_EQ(reclaimed, 0u);
}

// Has found, in a process of more than ten seconds: workers were lost before they could greet.
TEST_F(RemoteWorkers, ThatAreLostAreReplaced) {
    for (const Kind kind : {Kind::Flipped, Kind::Dies, Kind::Stopped}) {
        std::atomic<bool> hasFailed[2]{};
        m_workers.open("loopback", helloOf("1"), [&hasFailed, kind](std::string &) {
            auto transport =
                std::make_unique<LoopbackTransport>(2, helloOf("1"), solve, [&hasFailed, kind](unsigned worker, unsigned, dxRemoteKind message) {
                    if (message != dxRemoteKind::Results || hasFailed[worker].exchange(true)) return LoopbackFate();
                    return LoopbackFate{kind};
                });
            transport->setReplacing();
            return transport;
        });
        const unsigned before = m_workers.counts().replaced;
        const Clock::time_point begin = Clock::now();
        // One that stopped is taken for lost after seconds.
        while (m_workers.counts().replaced < before + 2 && Clock::now() - begin < std::chrono::seconds(20)) runBatch(40);
        EXPECT_GE(m_workers.counts().replaced, before + 2);
        unsigned reclaimed = 20;
        while (reclaimed > 0 && Clock::now() - begin < std::chrono::seconds(40)) reclaimed = runBatch(20, false);
        EXPECT_EQ(reclaimed, 0u);
        m_workers.close();
    }
}

// Each of four workers has one fault, at one of its first messages with results.
TEST_F(RemoteWorkers, AThousandFaultsChangeNothing) {
    constexpr unsigned kWorkers = 4, kRounds = 250;
    unsigned faults = 0;
    double longest = 0;
    for (unsigned round = 0; round < kRounds; ++round) {
        std::atomic<unsigned> happened{0};
        std::mt19937 random(round);
        LoopbackFate fates[kWorkers];
        unsigned at[kWorkers];
        for (unsigned i = 0; i < kWorkers; ++i) {
            constexpr Kind kinds[] = {Kind::Flipped, Kind::Dies, Kind::Stopped};
            fates[i].kind = kinds[random() % 3];
            fates[i].bit = random();
            at[i] = random() % 3;
        }
        constexpr unsigned kBefore = 8;  // hello and echoes
        open(kWorkers, [&](unsigned worker, unsigned count, dxRemoteKind) {
            if (count != kBefore + at[worker]) return LoopbackFate();
            ++happened;
            return fates[worker];
        });
        for (int step = 0; step < 20 && happened < kWorkers; ++step) {
            const dxStopwatch stopwatch;
            runBatch(24);
            longest = std::max(longest, stopwatch.ns());
        }
        m_workers.close();
        faults += happened;
        if (HasFailure()) FAIL() << "round " << round;
    }
    RecordProperty("faults", std::to_string(faults));
    RecordProperty("longest step (ms)", std::to_string(longest / 1e6));
    std::printf("%u faults, longest step %.1f ms\n", faults, longest / 1e6);
    EXPECT_GE(faults, 900u);
    const dxRemoteWorkers::Counts counts = countsSince(m_before);
    EXPECT_EQ(counts.outcomes.solved() + counts.outcomes.returned(), counts.sent);
}

}  // namespace
