// Worlds and spaces with numbers of threads of their own: more than the process's, or fewer, with the same bits.
//
// Covers api/ode_MT_workers.cpp.
#include "settings/dxOwnThreads.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <memory>
#include <thread>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdePool.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "processThreads.h"
#include "sanitizers.h"
#include "settings/dxProcessStatistics.h"

namespace {

template <class Work>
unsigned parallelSteps(const Work &work) {
    const unsigned before = dODE_MT_GetParallelSteps();
    work();
    return dODE_MT_GetParallelSteps() - before;
}

std::vector<dReal> serialState(unsigned steps) {
    ChainWorld serial(40, 4, dWorldStep);
    dODE_MT_SetWorldThreads(serial.world(), 1);
    EXPECT_EQ(parallelSteps([&] { serial.step(steps); }), 0u);
    return serial.state();
}

TEST(OwnThreads, OfAWorldInASerialProcess) {
    const OdeSession session(0, "lcp");
    const unsigned threadsBefore = processThreads();
    {
        ChainWorld own(40, 4, dWorldStep), other(40, 4, dWorldStep);
        EXPECT_EQ(dODE_MT_GetWorldThreads(own.world()), 0);
        EXPECT_EQ(dODE_MT_SetWorldThreads(own.world(), 3), 1);
        EXPECT_EQ(dODE_MT_GetWorldThreads(own.world()), 3);
        EXPECT_EQ(dODE_MT_GetWorldThreads(other.world()), 0);
        EXPECT_EQ(dODE_MT_GetThreads(), 0);
        EXPECT_EQ(parallelSteps([&] { own.step(20); }), 20u);
        EXPECT_EQ(parallelSteps([&] { other.step(20); }), 0u);
        EXPECT_EQ(own.state(), other.state());
        EXPECT_GT(processThreads(), threadsBefore);
        EXPECT_EQ(dODE_MT_SetWorldThreads(own.world(), 0), 1);
        EXPECT_TRUE(threadsFallTo(threadsBefore)) << "nobody has a number any more";
        EXPECT_EQ(parallelSteps([&] { own.step(); }), 0u);
    }
}

TEST(OwnThreads, OfAWorldInAParallelProcess) {
    const OdeSession session(3, "lcp");
    ChainWorld world(40, 4, dWorldStep);
    EXPECT_EQ(parallelSteps([&] { world.step(10); }), 10u);
    dODE_MT_SetWorldThreads(world.world(), 1);
    EXPECT_EQ(parallelSteps([&] { world.step(10); }), 0u);
    dODE_MT_SetWorldThreads(world.world(), dODE_MT_AUTO);
    EXPECT_GE(dODE_MT_GetWorldThreads(world.world()), 1);
    EXPECT_LE(dODE_MT_GetWorldThreads(world.world()), dODE_MT_MAX_THREADS);
    world.step(10);
    dODE_MT_SetWorldThreads(world.world(), 0);
    EXPECT_EQ(dODE_MT_GetWorldThreads(world.world()), 3);
    EXPECT_EQ(parallelSteps([&] { world.step(10); }), 10u);
    EXPECT_EQ(world.state(), serialState(40));
}

TEST(OwnThreads, TheAlgorithmSerialHoldsAllTheSame) {
    const OdeSession session(0, "serial");
    ChainWorld world(40, 4, dWorldStep);
    dODE_MT_SetWorldThreads(world.world(), 3);
    EXPECT_EQ(parallelSteps([&] { world.step(5); }), 0u);
}

TEST(OwnThreads, UpstreamsLimitHoldsToo) {
    const OdeSession session(0, "lcp");
    ChainWorld world(40, 4, dWorldStep);
    dODE_MT_SetWorldThreads(world.world(), 3);
    dWorldSetStepIslandsProcessingMaxThreadCount(world.world(), 1);
    EXPECT_EQ(parallelSteps([&] { world.step(5); }), 0u);
    dWorldSetStepIslandsProcessingMaxThreadCount(world.world(), 2);
    EXPECT_EQ(parallelSteps([&] { world.step(5); }), 5u);
}

TEST(OwnThreads, LimitThreadsThatServeTheWorld) {
    if (kThreadSanitizer) GTEST_SKIP() << "ODE's pool has races of its own, which ThreadSanitizer reports";
    const OdeSession session(0, "lcp");
    auto world = std::make_unique<ChainWorld>(40, 4, dWorldStep);
    const OdePool pool;
    pool.lendTo(world->world());
    EXPECT_EQ(parallelSteps([&] { world->step(5); }), 5u);
    dODE_MT_SetWorldThreads(world->world(), 1);
    EXPECT_EQ(parallelSteps([&] { world->step(5); }), 0u);
    EXPECT_EQ(world->state(), serialState(10));
    pool.shutDown();
    pool.freePool();
    world.reset();
    pool.freeThreading();
}

// A world that is made where one was destroyed has no number.
TEST(OwnThreads, EndWithTheirWorld) {
    const OdeSession session(2, "lcp");
    for (int i = 0; i < 20; ++i) {
        const ChainWorld world(2, 1);
        EXPECT_EQ(dODE_MT_GetWorldThreads(world.world()), 2);
        dODE_MT_SetWorldThreads(world.world(), 5);
        EXPECT_EQ(dxOwnThreads::largest(), 5u);
    }
    EXPECT_EQ(dxOwnThreads::largest(), 0u);
}

TEST(OwnThreads, OfASpace) {
    const OdeSession session(0, "lcp");
    std::vector<std::vector<dReal>> positions;
    for (const int threads : {0, 3, 1}) {
        dRandSetSeed(1);
        const dSpaceID space = dHashSpaceCreate(nullptr);
        HeapWorld heap(space);
        EXPECT_EQ(dODE_MT_GetSpaceThreads(space), 0);
        dODE_MT_SetSpaceThreads(space, threads);
        EXPECT_EQ(dODE_MT_GetSpaceThreads(space), threads);
        EXPECT_EQ(dxOwnThreads::largest(), static_cast<unsigned>(threads));
        const unsigned before = dODE_MT_GetContactsAhead();
        for (int frame = 0; frame < 15; ++frame) {
            heap.collide();
            heap.step();
        }
        EXPECT_EQ(dODE_MT_GetContactsAhead() != before, threads == 3);
        positions.push_back(heap.positions());
    }
    EXPECT_EQ(positions[0], positions[1]);
    EXPECT_EQ(positions[0], positions[2]);
    EXPECT_EQ(dxOwnThreads::largest(), 0u) << "destroyed";
}

TEST(OwnThreads, OfASpaceInAParallelProcess) {
    const OdeSession session(3, "lcp");
    const dSpaceID space = dHashSpaceCreate(nullptr);
    HeapWorld heap(space);
    dODE_MT_SetSpaceThreads(space, 1);
    const unsigned before = dODE_MT_GetContactsAhead();
    for (int frame = 0; frame < 12; ++frame) {  // the last ones with contacts
        heap.collide();
        heap.step();
    }
    EXPECT_EQ(dODE_MT_GetContactsAhead(), before);
    dODE_MT_SetSpaceThreads(space, 0);
    EXPECT_EQ(dODE_MT_GetSpaceThreads(space), 3);
    for (int frame = 0; frame < 5; ++frame) {
        heap.collide();
        heap.step();
    }
    EXPECT_GT(dODE_MT_GetContactsAhead(), before);
}

TEST(OwnThreads, NumbersOutOfRange) {
    const OdeSession session;
    const ChainWorld world(2, 1);
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    testing::internal::CaptureStderr();
    EXPECT_EQ(dODE_MT_SetWorldThreads(world.world(), -1), 1);
    EXPECT_EQ(dODE_MT_GetWorldThreads(world.world()), 0);
    EXPECT_EQ(dODE_MT_SetWorldThreads(world.world(), 100000), 1);
    EXPECT_EQ(dODE_MT_GetWorldThreads(world.world()), dODE_MT_MAX_THREADS);
    dODE_MT_SetSpaceThreads(space, -7);
    EXPECT_EQ(dODE_MT_GetSpaceThreads(space), 0);
    dODE_MT_SetSpaceThreads(space, 1025);
    EXPECT_EQ(dODE_MT_GetSpaceThreads(space), dODE_MT_MAX_THREADS);
    const std::string messages = testing::internal::GetCapturedStderr();
    for (const char *number : {"-1 threads", "100000 threads", "-7 threads", "1025 threads"})
        EXPECT_NE(messages.find(number), std::string::npos) << number;
    dSpaceDestroy(space);
}

// Many threads, each with a world and a number of its own.
TEST(OwnThreads, OfWorldsInManyThreads) {
    const OdeSession session(0, "lcp");
    const std::vector<dReal> expected = serialState(30);
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&expected, &wrong, i] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            for (int round = 0; round < 3; ++round) {
                ChainWorld world(40, 4, dWorldStep);
                for (int step = 0; step < 30; ++step) {
                    dODE_MT_SetWorldThreads(world.world(), (i + step) % 4);
                    world.step();
                }
                wrong += world.state() != expected;
            }
            dCleanupODEAllDataForThread();
        });
    for (std::thread &thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

// Two threads that set the number of one world, or of one space: whichever is last, no number is left when there is none.
TEST(OwnThreads, SetByTwoThreadsAtOnce) {
    const OdeSession session;
    const ChainWorld world(1, 1);
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    std::vector<std::thread> threads;
    for (int i = 0; i < 2; ++i)
        threads.emplace_back([&world, space, i] {
            for (int round = 0; round < 20000; ++round) {
                dODE_MT_SetWorldThreads(world.world(), (i + round) % 3);
                dODE_MT_SetSpaceThreads(space, (i + round) % 4);
            }
        });
    for (std::thread &thread : threads) thread.join();
    dODE_MT_SetWorldThreads(world.world(), 0);
    dODE_MT_SetSpaceThreads(space, 0);
    EXPECT_EQ(dxOwnThreads::largest(), 0u);
    dSpaceDestroy(space);
}

TEST(OwnThreads, InAForkedChild) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
    const OdeSession session(0, "lcp");
    ChainWorld world(40, 4, dWorldStep);
    dODE_MT_SetWorldThreads(world.world(), 3);
    world.step(10);
    EXPECT_TRUE(support::trueInChild([&] { return parallelSteps([&] { world.step(10); }) == 10 && dODE_MT_GetWorldThreads(world.world()) == 3; }));
    EXPECT_EQ(parallelSteps([&] { world.step(10); }), 10u);
}

}  // namespace
