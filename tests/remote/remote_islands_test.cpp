// Whole steps with remote workers have the bits of steps without: random worlds of many islands, with one thread at home and with several, while
// workers are well and while they send flipped bits. And a problem's bytes are solved as the problem is.
//
// Covers dxPackedProblem.cpp, dxPackedSolver.cpp, dxRemote.cpp.
#include "remote/islands/dxRemoteIslands.h"

#include <gtest/gtest.h>
#include <ode/ode_MT.h>

#include <cstddef>
#include <cstring>
#include <new>
#include <random>

#include "../dynamics/random_world.h"
#include "remote/islands/dxPackedProblem.h"
#include "remote/islands/dxPackedSolver.h"
#include "loopback_transport.h"

namespace {

using Kind = LoopbackFate::Kind;
using States = std::vector<std::vector<std::uint64_t>>;

constexpr RandomWorld::Shape kManyIslands{60, 55};

class RemoteIslands : public testing::TestWithParam<int> {
protected:
    RemoteIslands() {
        dInitODE2(0);
        dxRemoteSolvers::install(dxRemoteIslandSolvers());
        dODE_MT_SetAlgorithm("lcp");
    }
    ~RemoteIslands() override {
        dxRemoteWorkers::instance().close();
        dToggleODE_MT(0);
        dODE_MT_SetAlgorithm("auto");
        dCloseODE();
    }

    static void open(unsigned workers, LoopbackTransport::Fate fate = nullptr) {
        dxRemoteWorkers::instance().open("loopback", dxDescribeSolver(), [=](std::string &) {
            return std::make_unique<LoopbackTransport>(workers, dxDescribeSolver(), dxSolvePacked, fate);
        });
    }

    static dODE_MT_RemoteStatistics statistics() {
        dODE_MT_RemoteStatistics statistics;
        statistics.size = sizeof statistics;
        EXPECT_EQ(dODE_MT_GetRemoteStatistics(&statistics), 1);
        EXPECT_EQ(statistics.size, sizeof statistics);
        return statistics;
    }

    static dODE_MT_WorldStatistics statisticsOf(dWorldID world) {
        dODE_MT_WorldStatistics statistics;
        statistics.size = sizeof statistics;
        dODE_MT_GetWorldStatistics(world, &statistics);
        return statistics;
    }

    static States run(const RandomWorld::Shape &shape, unsigned seed, int steps = 12) {
        dRandSetSeed(seed);
        RandomWorld world(shape, seed);
        States states;
        for (int i = 0; i < steps; ++i) {
            world.push();
            dWorldStep(world.world(), dReal(0.01));
            states.push_back(world.state());
        }
        return states;
    }

    static void compare(const RandomWorld::Shape &shape, unsigned seed, unsigned workers, LoopbackTransport::Fate fate = nullptr) {
        const States expected = run(shape, seed);
        open(workers, fate);
        EXPECT_EQ(run(shape, seed), expected) << "seed " << seed;
        dxRemoteWorkers::instance().close();
    }
};

TEST_P(RemoteIslands, HaveTheBitsOfHome) {
    const std::uint64_t before = dxRemoteWorkers::instance().counts().outcomes.solved();
    dToggleODE_MT(GetParam());
    for (unsigned seed = 1; seed <= 8; ++seed) compare(kManyIslands, seed, 1 + seed % 3);
    EXPECT_GT(dxRemoteWorkers::instance().counts().outcomes.solved(), before + 100) << "of islands, there";
}

TEST_P(RemoteIslands, HaveTheBitsOfHomeWhateverBecomesOfWorkers) {
    dToggleODE_MT(GetParam());
    for (unsigned seed = 1; seed <= 12; ++seed) {
        // What is forced waits for seconds for workers that are not heard of: they are for remote_workers_test.
        compare(kManyIslands, seed, 2, [seed](unsigned worker, unsigned count, dxRemoteKind kind) {
            std::mt19937 random(seed * 1000 + worker * 100 + count);
            if (kind != dxRemoteKind::Results || random() % 6 != 0) return LoopbackFate();
            return LoopbackFate{Kind::Flipped, {}, static_cast<unsigned>(random())};
        });
    }
}

// The process's counts are those of its worlds.
TEST_P(RemoteIslands, AreCounted) {
    dToggleODE_MT(GetParam());
    open(2);
    const dODE_MT_RemoteStatistics before = statistics();
    EXPECT_EQ(before.workers, 2u);
    RandomWorld world(kManyIslands, 3);
    statisticsOf(world.world());  // begins to record
    unsigned long long solved = 0;
    for (int i = 0; i < 5; ++i) {
        dWorldStep(world.world(), dReal(0.01));
        const dODE_MT_WorldStatistics last = statisticsOf(world.world());
        EXPECT_EQ(last.remoteWorkers, 2u);
        EXPECT_EQ(last.returnedIslands, 0u);
        solved += last.remoteIslands;
        EXPECT_EQ(last.allRemoteIslands, solved);
    }
    const dODE_MT_RemoteStatistics after = statistics();
    EXPECT_GT(solved, 0u);
    EXPECT_EQ(after.islandsSolved - before.islandsSolved, solved);
    EXPECT_EQ(after.islandsSent - before.islandsSent, solved);

    dWorldQuickStep(world.world(), dReal(0.01));
    EXPECT_EQ(statisticsOf(world.world()).remoteIslands, 0u) << "which stays at home";
    EXPECT_EQ(statisticsOf(world.world()).allRemoteIslands, solved);
}

TEST_P(RemoteIslands, HaveTheirRowsCounted) {
    dToggleODE_MT(GetParam());
    const auto rows = [] {
        RandomWorld world(kManyIslands, 3);
        statisticsOf(world.world());  // begins to record
        dWorldStep(world.world(), dReal(0.01));
        return statisticsOf(world.world()).rows;
    };
    const unsigned long long atHome = rows();
    EXPECT_GT(atHome, 0u);
    open(2);
    const unsigned long long sent = statistics().islandsSent;
    EXPECT_EQ(rows(), atHome);
    EXPECT_GT(statistics().islandsSent, sent);
}

TEST_P(RemoteIslands, AreCountedWhenWorkersGiveThemBack) {
    dToggleODE_MT(GetParam());
    const States expected = run(kManyIslands, 4);
    dxRemoteWorkers::instance().open("loopback", dxDescribeSolver(), [](std::string &) {
        return std::make_unique<LoopbackTransport>(1, dxDescribeSolver(),
                                                   [](const std::byte *, std::size_t, dxRemoteBytes &) { throw std::bad_alloc(); });
    });
    const dODE_MT_RemoteStatistics before = statistics();
    EXPECT_EQ(run(kManyIslands, 4), expected);
    const dODE_MT_RemoteStatistics after = statistics();
    EXPECT_GT(after.islandsSent, before.islandsSent);
    EXPECT_EQ(after.islandsSolved, before.islandsSolved);
    EXPECT_EQ(after.islandsGivenBack - before.islandsGivenBack, after.islandsSent - before.islandsSent);
    EXPECT_EQ(after.workersLost, before.workersLost);
}

TEST_P(RemoteIslands, AreCountedWhenWorkersAreLost) {
    dToggleODE_MT(GetParam());
    open(1, [](unsigned, unsigned, dxRemoteKind kind) {
        return LoopbackFate{kind == dxRemoteKind::Results ? Kind::Flipped : Kind::Arrives, {}, 300};
    });
    const dODE_MT_RemoteStatistics before = statistics();
    RandomWorld world(kManyIslands, 5);
    statisticsOf(world.world());
    dWorldStep(world.world(), dReal(0.01));
    const dODE_MT_RemoteStatistics after = statistics();
    const dODE_MT_WorldStatistics last = statisticsOf(world.world());
    EXPECT_EQ(after.workers, 0u);
    EXPECT_EQ(after.workersLost, before.workersLost + 1);
    EXPECT_EQ(last.remoteWorkersLost, after.workersLost);
    EXPECT_GT(last.returnedIslands, 0u);
    EXPECT_EQ(after.islandsLost - before.islandsLost, last.returnedIslands);
    EXPECT_EQ(last.remoteIslands, 0u);
}

TEST(RemoteStatistics, TheSizeSaysHowMuchIsWritten) {
    dODE_MT_RemoteStatistics small;
    std::memset(&small, 0xaa, sizeof small);
    const dODE_MT_RemoteStatistics untouched = small;
    small.size = offsetof(dODE_MT_RemoteStatistics, islandsSent);
    EXPECT_EQ(dODE_MT_GetRemoteStatistics(&small), 1);
    EXPECT_EQ(small.size, offsetof(dODE_MT_RemoteStatistics, islandsSent));
    EXPECT_EQ(small.workers, 0u);
    EXPECT_EQ(small.islandsSent, untouched.islandsSent);
    small.size = sizeof small.size;
    EXPECT_EQ(dODE_MT_GetRemoteStatistics(&small), 0);
}

INSTANTIATE_TEST_SUITE_P(, RemoteIslands, testing::Values(0, 2, 5), [](const testing::TestParamInfo<int> &info) {
    return "Threads" + std::to_string(info.param);
});

TEST(PackedProblem, ShorterOrDamagedBytesAreSolvedOrGivenBack) {
    // What a worker that is sent nonsense does: the bytes are the first problem of the self-test's kind, taken from a link.
    std::vector<dxRemoteBytes> problems;
    dInitODE2(0);
    dxRemoteSolvers::install(dxRemoteIslandSolvers());
    dODE_MT_SetAlgorithm("lcp");
    dxRemoteWorkers::instance().open("loopback", dxDescribeSolver(), [&problems](std::string &) {
        return std::make_unique<LoopbackTransport>(1, dxDescribeSolver(),
                                                   [&problems](const std::byte *data, std::size_t size, dxRemoteBytes &result) {
                                                       problems.emplace_back(data, data + size);
                                                       dxSolvePacked(data, size, result);
                                                   });
    });
    {
        RandomWorld world(kManyIslands, 3);
        dWorldStep(world.world(), dReal(0.01));
    }
    dxRemoteWorkers::instance().close();
    dODE_MT_SetAlgorithm("auto");
    dCloseODE();
    ASSERT_FALSE(problems.empty());
    const dxRemoteBytes &whole = problems.front();
    dxRemoteBytes result;
    const auto outcome = [&result] {
        dxPackedResult::Head head;
        std::memcpy(&head, result.data(), sizeof head);
        return head.outcome;
    };
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        dxSolvePacked(whole.data(), size, result);
        EXPECT_EQ(outcome(), dxPackedResult::Outcome::GivenBack) << size;
    }
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        dxRemoteBytes damaged = whole;
        damaged[random() % damaged.size()] = std::byte(random());
        damaged[random() % 200] = std::byte(random());
        dxSolvePacked(damaged.data(), damaged.size(), result);
        EXPECT_GE(result.size(), sizeof(dxPackedResult::Head));
    }
}

}  // namespace
