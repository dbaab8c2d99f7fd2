// A world's limits of threads for one island and for its LCP, which came with ODE 0.16.6: upper bounds for a large island, and for
// nothing else.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "OdePool.h"
#include "OdeSession.h"
#include "PackedWorld.h"

namespace {

constexpr unsigned kUnlimited = dWORLDSTEP_THREADCOUNT_UNLIMITED;

void limit(dWorldID world, unsigned which, unsigned threads) {
    const dWorldSteppingThreadingParameters parameters = {which, threads, threads, threads};
    dWorldSetSteppingThreadingParameters(world, &parameters);
}

// Boxes that are one large island.
struct LargeIsland : PackedWorld {
    LargeIsland() : PackedWorld(10, 10, 2, dWorldQuickStep) {}

    // Several steps, as a second worker may come too late for one.
    bool isSteppedTogether() {
        const unsigned before = dODE_MT_GetTeamSteps();
        for (int i = 0; i < 20 && dODE_MT_GetTeamSteps() == before; ++i) frame();
        return dODE_MT_GetTeamSteps() != before;
    }
};

class SteppingThreads : public testing::Test {
protected:
    bool isSteppedTogether() { return m_world.isSteppedTogether(); }

    const OdeSession m_session{2, "lcp"};
    LargeIsland m_world;
};

TEST_F(SteppingThreads, AreAsUpstreamsUntilTheyAreSet) {
    dWorldSteppingThreadingParameters parameters = {
        dWSTP_WorldIslandsIterationMaxThreads | dWSTP_IslandSteppingMaxThreads | dWSTP_LCPSolvingMaxThreads, 77, 77, 77};
    dWorldGetSteppingThreadingParameters(m_world.world(), &parameters);
    EXPECT_EQ(parameters.world_islands_iteration_max_threads, kUnlimited);
    EXPECT_EQ(parameters.island_stepping_max_threads, kUnlimited);
    EXPECT_EQ(parameters.lcp_solving_max_threads, 1u);
}

// Upstream's default of one thread for the LCP is none that the program has set.
TEST_F(SteppingThreads, OfTheDefaultDoNotBind) { EXPECT_TRUE(isSteppedTogether()); }

TEST_F(SteppingThreads, OfOneIslandBind) {
    limit(m_world.world(), dWSTP_IslandSteppingMaxThreads, 1);
    EXPECT_FALSE(isSteppedTogether());
    limit(m_world.world(), dWSTP_IslandSteppingMaxThreads, 2);
    EXPECT_TRUE(isSteppedTogether());
}

TEST_F(SteppingThreads, OfTheLcpBindOnceTheyAreSet) {
    limit(m_world.world(), dWSTP_LCPSolvingMaxThreads, 1);
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    dODE_MT_GetWorldStatistics(m_world.world(), &statistics);  // frames are recorded from here on
    EXPECT_FALSE(isSteppedTogether());
    ASSERT_EQ(dODE_MT_GetWorldStatistics(m_world.world(), &statistics), 1);
    EXPECT_EQ(statistics.stepReason, dODE_MT_REASON_WORLD_LIMIT);
    limit(m_world.world(), dWSTP_LCPSolvingMaxThreads, kUnlimited);
    EXPECT_TRUE(isSteppedTogether());
}

// Another world at the address of a destroyed one has its own limits.
TEST_F(SteppingThreads, GoWithTheirWorld) {
    const dWorldID world = dWorldCreate();
    limit(world, dWSTP_LCPSolvingMaxThreads, 1);
    dWorldDestroy(world);
    EXPECT_TRUE(isSteppedTogether());
    EXPECT_TRUE(LargeIsland().isSteppedTogether());
}

// Functions of the user's own in a world that is limited to one thread for islands: upstream's stepper runs, and would step an island on
// all threads that these limits allow, in another order of additions each time.
TEST_F(SteppingThreads, DoNotLetThePoolStepAnIslandOfAWorldOfOneThread) {
    LargeIsland serial;
    dToggleODE_MT(0);
    dRandSetSeed(3);
    for (int i = 0; i < 10; ++i) serial.frame();

    const OdePool pool;
    dThreadingFunctionsInfo own = *dThreadingImplementationGetFunctions(pool.threading());
    dWorldSetStepThreadingImplementation(m_world.world(), &own, pool.threading());
    dWorldSetStepIslandsProcessingMaxThreadCount(m_world.world(), 1);
    limit(m_world.world(), dWSTP_IslandSteppingMaxThreads | dWSTP_LCPSolvingMaxThreads, 4);
    dRandSetSeed(3);
    for (int i = 0; i < 10; ++i) m_world.frame();
    EXPECT_EQ(m_world.state(), serial.state());

    pool.shutDown();
    pool.freePool();
    OdePool::takeFrom(m_world.world());
    pool.freeThreading();
}

}  // namespace
