// fork in the host program: parent and child go on with their own copy of the world and get the same bits.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

class Fork : public testing::TestWithParam<const char *> {
protected:
    void SetUp() override {
        if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
        dODE_MT_SetThreadManager(GetParam());
    }
    void TearDown() override { dODE_MT_SetThreadManager("pthread"); }
};

TEST_P(Fork, ChildStepsAsTheParent) {
    const OdeSession session(4, "lcp");
    ChainWorld world(64, 5), serial(64, 5);
    dRandSetSeed(1);
    world.step(10);
    const unsigned long seed = dRandGetSeed();
    dRandSetSeed(1);
    OdeSession::use(0, "serial");
    serial.step(20);
    OdeSession::use(4, "lcp");
    dRandSetSeed(seed);
    EXPECT_TRUE(support::trueInChild([&] {
        world.step(10);
        return world.state() == serial.state() && dODE_MT_GetParallelSteps() >= 20;
    }));
    world.step(10);
    EXPECT_EQ(world.state(), serial.state());
}

TEST_P(Fork, ChildCanCloseAndStartAgain) {
    const OdeSession session(4, "lcp");
    {
        ChainWorld world(64, 5);
        world.step(10);
    }
    EXPECT_TRUE(support::trueInChild([] {
        dCloseODE();
        const OdeSession again(3, "lcp");
        ChainWorld world(64, 5);
        world.step(10);
        return true;
    }));
}

// The locks that the other thread may hold at that moment are gone from the child.
TEST_P(Fork, WhileAnotherThreadSteps) {
    if (kAddressSanitizer) GTEST_SKIP() << "AddressSanitizer's own locks do not survive a fork";
    const OdeSession session(3, "lcp");
    std::atomic<bool> enough{false};
    std::thread other([&enough] {
        ChainWorld world(30, 4);
        while (!enough) world.step();
    });
    ChainWorld world(30, 4);
    for (int i = 0; i < 30; ++i) {
        EXPECT_TRUE(support::trueInChild([&] {
            world.step(3);
            dToggleODE_MT(2);
            world.step(3);
            dCloseODE();
            return true;
        })) << "child "
            << i;
    }
    enough = true;
    other.join();
}

// A fork while another thread uses the library for the first time: what that thread is making at that moment
// is whole in the child, or not begun. Each try is a process that has not stepped before.
TEST_P(Fork, WhileAnotherThreadStepsForTheFirstTime) {
    if (kAddressSanitizer) GTEST_SKIP() << "AddressSanitizer's own locks do not survive a fork";
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        EXPECT_TRUE(support::trueInChild([i] {
            const OdeSession session(3, "lcp");
            std::atomic<bool> stepping{false};
            std::thread other([&stepping] {
                ChainWorld world(30, 4);
                stepping = true;
                world.step(3);
            });
            ChainWorld world(30, 4);
            while (!stepping) continue;
            std::this_thread::sleep_for(std::chrono::microseconds(i));
            const bool done = support::trueInChild([&world] {
                world.step(3);
                dCloseODE();
                return true;
            });
            other.join();
            return done;
        })) << "try "
            << i;
        if (HasFailure()) break;
    }
}

INSTANTIATE_TEST_SUITE_P(Managers, Fork, testing::Values("pthread", "openmp"),
                         [](const auto &info) { return info.param; });

}  // namespace
