// A world with a thread pool of the user: its threads step islands, the bits are those of a serial step,
// and the pool can be freed in every order that upstream allows.
//
// Covers api/objects.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <memory>

#include "ChainWorld.h"
#include "OdePool.h"
#include "OdeSession.h"
#include "processThreads.h"
#include "Runs.h"
#include "sanitizers.h"
#include "settings/dxProcessStatistics.h"

namespace {

class UserPool : public testing::Test {
protected:
    // Waiting for calls that never come shows as a warning after a second.
    void SetUp() override {
        if (kThreadSanitizer)
            GTEST_SKIP() << "ODE's pool has races of its own, which ThreadSanitizer reports";
        testing::internal::CaptureStderr();
    }
    void TearDown() override {
        if (kThreadSanitizer) return;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        EXPECT_TRUE(threadsFallTo(threadsBefore));
    }

    static std::unique_ptr<ChainWorld> makeWorld() { return std::make_unique<ChainWorld>(40, 4); }

    const unsigned threadsBefore = processThreads();
    OdeSession session{0, "lcp"};
    std::unique_ptr<ChainWorld> world = makeWorld();
};

TEST_F(UserPool, StepsIslandsWithSerialBits) {
    const auto serial = makeWorld();
    dRandSetSeed(2);
    serial->step(20);
    const OdePool pool;
    pool.lendTo(world->world());
    dRandSetSeed(2);
    const unsigned before = dODE_MT_GetParallelSteps();
    world->step(20);
    EXPECT_EQ(dODE_MT_GetParallelSteps(), before + 20);
    dxProcessStatistics::instance().maxWorkersUsed = 0;
    EXPECT_EQ(world->state(), serial->state());
    EXPECT_TRUE(waitUntil(
        [&] {
            world->step();
            return dODE_MT_GetMaxWorkersUsed() >= 2;
        },
        30));
    pool.shutDown();
    pool.freePool();
    OdePool::takeFrom(world->world());
    pool.freeThreading();
    world->step();
}

TEST_F(UserPool, WorldsLimitHolds) {
    const OdePool pool;
    pool.lendTo(world->world());
    dWorldSetStepIslandsProcessingMaxThreadCount(world->world(), 1);
    const unsigned before = dODE_MT_GetParallelSteps();
    world->step(5);
    EXPECT_EQ(dODE_MT_GetParallelSteps(), before);
    pool.shutDown();
    pool.freePool();
    OdePool::takeFrom(world->world());
    pool.freeThreading();
}

TEST_F(UserPool, TakenFromTheWorldBeforeItIsShutDown) {
    for (int i = 0; i < 20; ++i) {
        const OdePool pool;
        pool.lendTo(world->world());
        world->step(3);
        OdePool::takeFrom(world->world());
        pool.shutDown();
        pool.freePool();
        pool.freeThreading();
    }
}

TEST_F(UserPool, FreedInTheOrderOfTheDemos) {
    for (int i = 0; i < 20; ++i) {
        const OdePool pool;
        pool.lendTo(world->world());
        world->step(3);
        pool.shutDown();
        pool.freePool();
        OdePool::takeFrom(world->world());
        pool.freeThreading();
        world->step();
    }
}

TEST_F(UserPool, WorldDestroyedWhileItIsServed) {
    for (int i = 0; i < 20; ++i) {
        const OdePool pool;
        pool.lendTo(world->world());
        world->step(3);
        world = makeWorld();
        pool.shutDown();
        pool.freePool();
        pool.freeThreading();
    }
}

TEST_F(UserPool, WorldDestroyedAfterShutDown) {
    const OdePool pool;
    pool.lendTo(world->world());
    world->step(3);
    pool.shutDown();
    pool.freePool();
    world.reset();
    pool.freeThreading();
}

TEST_F(UserPool, NeverStepped) {
    const OdePool pool;
    pool.lendTo(world->world());
    pool.shutDown();
    pool.freePool();
    OdePool::takeFrom(world->world());
    pool.freeThreading();
}

TEST_F(UserPool, SharedByTwoWorlds) {
    const auto second = makeWorld();
    const OdePool pool;
    for (const ChainWorld *each : {world.get(), second.get()}) pool.lendTo(each->world());
    world->step(3);
    second->step(3);
    OdePool::takeFrom(world->world());
    second->step(3);
    pool.shutDown();
    pool.freePool();
    OdePool::takeFrom(second->world());
    pool.freeThreading();
}

TEST_F(UserPool, ExchangedForAnother) {
    const OdePool first, second(2);
    first.lendTo(world->world());
    world->step(3);
    second.lendTo(world->world());
    world->step(3);
    first.shutDown();
    first.freePool();
    first.freeThreading();
    world->step(3);
    OdePool::takeFrom(world->world());
    second.shutDown();
    second.freePool();
    second.freeThreading();
}

// The threads come after the first steps.
TEST_F(UserPool, ServedLate) {
    const dThreadingImplementationID threading = dThreadingAllocateMultiThreadedImplementation();
    dWorldSetStepThreadingImplementation(world->world(), dThreadingImplementationGetFunctions(threading),
                                         threading);
    world->step(3);
    const dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(2, 0, dAllocateFlagBasicData, nullptr);
    dThreadingThreadPoolServeMultiThreadedImplementation(pool, threading);
    world->step(3);
    dThreadingImplementationShutdownProcessing(threading);
    dThreadingFreeThreadPool(pool);
    dWorldSetStepThreadingImplementation(world->world(), nullptr, nullptr);
    dThreadingFreeImplementation(threading);
}

TEST_F(UserPool, SelfThreadedImplementationStaysSerial) {
    const dThreadingImplementationID threading = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(world->world(), dThreadingImplementationGetFunctions(threading),
                                         threading);
    const unsigned before = dODE_MT_GetParallelSteps();
    world->step(5);
    EXPECT_EQ(dODE_MT_GetParallelSteps(), before);
    dWorldSetStepThreadingImplementation(world->world(), nullptr, nullptr);
    dThreadingFreeImplementation(threading);
}

TEST_F(UserPool, BorrowedThreadsAreBackWhenTheLibraryIsClosed) {
    const OdePool pool;
    pool.lendTo(world->world());
    world->step(3);
    OdePool::takeFrom(world->world());
    world.reset();
    dCloseODE();
    pool.shutDown();
    pool.freePool();
    pool.freeThreading();
    dInitODE2(0);
}

}  // namespace
