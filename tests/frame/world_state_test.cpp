// What is kept beside worlds: one state for each, found whatever the number of worlds, and gone with its world.
#include "settings/dxWorldState.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <thread>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "threading/process/dxProcess.h"

namespace {

TEST(WorldState, IsMadeWhenSomethingIsKept) {
    const OdeSession session;
    const ChainWorld chains(2, 2);
    EXPECT_EQ(dxWorldState::find(chains.world()), nullptr) << "a world that is as the process says";
    dODE_MT_SetWorldThreads(chains.world(), 0);
    EXPECT_EQ(dxWorldState::find(chains.world()), nullptr) << "the process's number is no number of its own";
    dODE_MT_SetWarmStart(chains.world(), 0);
    EXPECT_NE(dxWorldState::find(chains.world()), nullptr);
}

TEST(WorldState, SettingsBeginAsTheProcesses) {
    const OdeSession session(3, "lcp");
    const ChainWorld chains(1, 1);
    const dxWorldSettings before = dxWorldSettings::of(chains.world());
    dODE_MT_SetSolverTolerance(chains.world(), 0.25);
    dODE_MT_SetWorldThreads(chains.world(), 2);
    const dxWorldSettings after = dxWorldSettings::of(chains.world());
    EXPECT_EQ(after.solver.solver, before.solver.solver);
    EXPECT_EQ(after.solver.isWarm, before.solver.isWarm);
    EXPECT_EQ(after.solver.tolerance, 0.25);
    EXPECT_EQ(after.solvingLimit, dWORLDSTEP_THREADCOUNT_UNLIMITED);
    EXPECT_EQ(before.threads, 0u);
    EXPECT_EQ(before.threadsInForce(), 3u);
    EXPECT_EQ(after.threads, 2u);
    EXPECT_EQ(after.threadsInForce(), 2u);
}

// More worlds than the table has places.
TEST(WorldState, OfManyWorlds) {
    const OdeSession session;
    constexpr int kWorlds = 3000;
    std::vector<dWorldID> worlds;
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < kWorlds; ++i) {
            worlds.push_back(dWorldCreate());
            EXPECT_EQ(dxWorldState::find(worlds.back()), nullptr);
            dODE_MT_SetSolverTolerance(worlds.back(), 1.0 / (i + 1));
        }
        for (int i = 0; i < kWorlds; ++i) ASSERT_EQ(dODE_MT_GetSolverTolerance(worlds[i]), 1.0 / (i + 1));
        int states = 0;
        dxWorldState::forAll([&states](const dxWorldState &) { ++states; });
        EXPECT_EQ(states, kWorlds);
        for (int i = 0; i < kWorlds; i += 2) dWorldDestroy(worlds[i]);
        for (int i = 1; i < kWorlds; i += 2) ASSERT_EQ(dODE_MT_GetSolverTolerance(worlds[i]), 1.0 / (i + 1));
        for (int i = 1; i < kWorlds; i += 2) dWorldDestroy(worlds[i]);
        worlds.clear();
    }
}

struct CountedPart final : dxWorldPart {
    explicit CountedPart(int &living) : m_living(living) { ++m_living; }
    ~CountedPart() override { --m_living; }
    int &m_living;
};

TEST(WorldState, PartsEndWithTheWorldOrWithTheLibrary) {
    int living = 0;
    {
        const OdeSession session;
        const dWorldID first = dWorldCreate(), second = dWorldCreate();
        for (const dWorldID world : {first, second}) dxWorldState::of(world).fastQuickStep = std::make_unique<CountedPart>(living);
        EXPECT_EQ(living, 2);
        dWorldDestroy(first);
        EXPECT_EQ(living, 1);
        dxProcess::close();
        EXPECT_EQ(living, 0);
        dWorldDestroy(second);
    }
    EXPECT_EQ(living, 0);
}

TEST(WorldState, IsMadeOnceByThreadsAtTheSameTime) {
    const OdeSession session;
    for (int round = 0; round < 300; ++round) {
        const dWorldID world = dWorldCreate();
        dxWorldState *states[3] = {};
        std::atomic<int> ready{0};
        std::vector<std::thread> threads;
        for (dxWorldState *&state : states)
            threads.emplace_back([world, &state, &ready] {
                for (++ready; ready < 3;) std::this_thread::yield();
                state = &dxWorldState::of(world);
            });
        for (std::thread &thread : threads) thread.join();
        EXPECT_EQ(states[0], states[1]);
        EXPECT_EQ(states[0], states[2]);
        EXPECT_EQ(dxWorldState::find(world), states[0]);
        dWorldDestroy(world);
    }
}

TEST(WorldState, InAForkedChild) {
    const OdeSession session;
    const dWorldID world = dWorldCreate();
    dODE_MT_SetSolverTolerance(world, 0.5);
    EXPECT_TRUE(support::trueInChild([world] {
        const dWorldID another = dWorldCreate();
        dODE_MT_SetSolverTolerance(another, 0.125);
        return dODE_MT_GetSolverTolerance(world) == 0.5 && dODE_MT_GetSolverTolerance(another) == 0.125;
    }));
    dWorldDestroy(world);
}

}  // namespace
