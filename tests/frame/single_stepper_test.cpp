// A second thread's first step waits for the step in progress, however long that takes (contract C7); but not for ever
// where the user's code in that step may be waiting for it. Each in a process of its own, in which no thread has stepped.
//
// Covers dxSerialStep.cpp.
#include "dynamics/step/random/dxSingleStepper.h"

#include <fenv.h>
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <chrono>
#include <csetjmp>
#include <thread>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "Deadline.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

class SingleStepper : public testing::Test {};

TEST_F(SingleStepper, IsAwaitedForLongerThanASecond) {
    EXPECT_TRUE(support::trueInChild([] {
        std::atomic<bool> ended{false}, hasBegun{false}, sawEnd{false};
        std::thread other;
        {
            const dxSingleStepper step;
            if (!step.alone()) return false;
            other = std::thread([&] {
                hasBegun = true;
                const dxSingleStepper second;
                sawEnd = ended.load() && !second.alone();
            });
            comesTrue([&] { return hasBegun.load(); });
            std::this_thread::sleep_for(1500ms);
            ended = true;
        }
        other.join();
        return sawEnd.load();
    }));
}

// A long step draws in order: the bits are those of one whole step after the other.
TEST_F(SingleStepper, LongStepsDrawInOrder) {
    const auto run = [](bool atOnce, int iterations) {
        dRandSetSeed(3);
        ChainWorld longer(6, 4), shorter(4, 3);
        dWorldSetQuickStepNumIterations(longer.world(), iterations);
        std::thread other;
        const auto stepOther = [&shorter, atOnce] {
            if (atOnce) std::this_thread::sleep_for(50ms);
            shorter.step();
        };
        if (atOnce) other = std::thread(stepOther);
        const Clock::time_point start = Clock::now();
        longer.step();
        const bool isLong = Clock::now() - start > 1200ms;
        if (!atOnce) stepOther();
        if (other.joinable()) other.join();
        std::vector<dReal> both = longer.state(), more = shorter.state();
        both.insert(both.end(), more.begin(), more.end());
        return std::make_pair(both, isLong);
    };
    EXPECT_TRUE(support::trueInChild([&run] {
        const OdeSession session(0, "serial");
        int iterations = 50000;
        auto inOrder = run(false, iterations);
        while (!inOrder.second) inOrder = run(false, iterations *= 2);
        return inOrder.first == run(true, iterations).first;
    }));
}

TEST_F(SingleStepper, DoesNotHoldUpAThreadThatItsCallbackWaitsFor) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(0, "serial");
        ChainWorld world(3, 3);
        dBodySetMovedCallback(world.bodies()[4], [](dBodyID) {
            static bool done = false;
            if (done) return;
            done = true;
            std::thread([] { ChainWorld(3, 3).step(); }).join();
        });
        world.step(2);
        return true;
    }));
}

TEST_F(SingleStepper, NorOneThatWasLeftByLongjmp) {
    EXPECT_TRUE(support::trueInChild([] {
        static std::jmp_buf place;
        const OdeSession session(0, "serial");
        auto &world = *new ChainWorld(3, 3);
        dBodySetMovedCallback(world.bodies()[4], [](dBodyID) { std::longjmp(place, 1); });
        if (setjmp(place) == 0) world.step();
        dBodySetMovedCallback(world.bodies()[4], nullptr);
        world.step();  // alone, and over: it is not taken for a part of the one that was left
        const Clock::time_point start = Clock::now();
        std::thread([] { ChainWorld(3, 3).step(); }).join();
        _exit(Clock::now() - start < 900ms ? 0 : 1);
        return true;
    }));
}

// So may the handler of a floating-point exception.
TEST_F(SingleStepper, NorOneThatTrapsFloatingPointExceptions) {
    EXPECT_TRUE(support::trueInChild([] {
        static std::jmp_buf place;
        feenableexcept(FE_DIVBYZERO);
        if (setjmp(place) == 0) {
            const dxSingleStepper step;
            std::longjmp(place, 1);
        }
        std::thread([] { const dxSingleStepper step; }).join();
        return true;
    }));
}

// In a child forked by another thread no thread continues the step.
TEST_F(SingleStepper, IsNotAwaitedInAForkedChild) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
    EXPECT_TRUE(support::trueInChild([] {
        std::atomic<bool> isStepping{false}, enough{false};
        std::thread stepping([&] {
            const dxSingleStepper step;
            isStepping = true;
            comesTrue([&] { return enough.load(); });
        });
        comesTrue([&] { return isStepping.load(); });
        const bool done = support::trueInChild([] {
            const dxSingleStepper step;
            return true;
        });
        enough = true;
        stepping.join();
        return done;
    }));
}

}  // namespace
