// Which steps run in parallel, and that their bits are those of a serial one.
//
// Covers dxBodyMotion.cpp, dxDeferredIslands.cpp, dxIslandParallelStep.cpp, dxIslandPreparation.cpp, dxIslandStepper.cpp, dxStepStrategy.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <thread>

#include "ChainWorld.h"
#include "OdeSession.h"
#include "Runs.h"
#include "sanitizers.h"
#include "settings/dxProcessStatistics.h"
#include "threading/dxSchedulePoints.h"

namespace {

unsigned g_movedCalls;

struct Shared {
    unsigned steps, islands;
};

// What the steps of `function` add to the counters.
template <class Function>
Shared sharedIn(Function function) {
    const Shared before{dODE_MT_GetParallelSteps(), dODE_MT_GetParallelIslands()};
    function();
    return {dODE_MT_GetParallelSteps() - before.steps, dODE_MT_GetParallelIslands() - before.islands};
}

class Step : public testing::TestWithParam<dWorldStepFunction *> {
protected:
    static constexpr unsigned kChains = 30, kLinks = 4;

    void SetUp() override {
        OdeSession::use(0, "serial");
        dRandSetSeed(9);
        serial.step(10);
        serialSeed = dRandGetSeed();
        dRandSetSeed(9);
    }

    void expectSerialBits() const {
        EXPECT_EQ(world.state(), serial.state());
        EXPECT_EQ(dRandGetSeed(), serialSeed);
    }

    OdeSession session;
    ChainWorld world{kChains, kLinks, GetParam()}, serial{kChains, kLinks, GetParam()};
    unsigned long serialSeed = 0;
};

TEST_P(Step, LcpSharesEveryStep) {
    OdeSession::use(3, "lcp");
    const Shared shared = sharedIn([&] { world.step(10); });
    EXPECT_EQ(shared.steps, 10u);
    EXPECT_EQ(shared.islands, 10 * kChains);
    expectSerialBits();
}

TEST_P(Step, TwoWorkersDoRealWork) {
    OdeSession::use(3, "lcp");
    dxProcessStatistics::instance().maxWorkersUsed = 0;
    dxSetRandomPerturbation(1);  // sleeping threads leave work to the others
    EXPECT_TRUE(waitUntil(
        [&] {
            world.step();
            return dODE_MT_GetMaxWorkersUsed() >= 2;
        },
        30));
    EXPECT_LE(dODE_MT_GetMaxWorkersUsed(), 3u);
    dxSetPerturbation(nullptr);
}

TEST_P(Step, DisturbedSchedulesGiveSerialBits) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        OdeSession::use(2 + seed % 4, "lcp");
        dxSetRandomPerturbation(seed);
        ChainWorld disturbed(kChains, kLinks, GetParam());
        dRandSetSeed(9);
        disturbed.step(10);
        EXPECT_EQ(disturbed.state(), serial.state());
        EXPECT_EQ(dRandGetSeed(), serialSeed);
    }
    dxSetPerturbation(nullptr);
}

TEST_P(Step, SerialSharesNothing) {
    OdeSession::use(3, "serial");
    EXPECT_EQ(sharedIn([&] { world.step(10); }).steps, 0u);
    expectSerialBits();
}

TEST_P(Step, OneThreadSharesNothing) {
    OdeSession::use(1, "lcp");
    EXPECT_EQ(sharedIn([&] { world.step(10); }).steps, 0u);
    expectSerialBits();
}

TEST_P(Step, OneIslandIsNotShared) {
    OdeSession::use(3, "lcp");
    ChainWorld one(1, 10, GetParam());
    EXPECT_EQ(sharedIn([&] { one.step(10); }).steps, 0u);
}

TEST_P(Step, EmptyWorldSteps) {
    OdeSession::use(3, "lcp");
    ChainWorld empty(0, 0, GetParam());
    EXPECT_EQ(sharedIn([&] { empty.step(3); }).steps, 0u);
}

TEST_P(Step, WorldsOwnLimitOfOneThreadKeepsItSerial) {
    OdeSession::use(3, "lcp");
    dWorldSetStepIslandsProcessingMaxThreadCount(world.world(), 1);
    EXPECT_EQ(sharedIn([&] { world.step(5); }).steps, 0u);
    dWorldSetStepIslandsProcessingMaxThreadCount(world.world(), 2);
    EXPECT_EQ(sharedIn([&] { world.step(5); }).steps, 5u);
    expectSerialBits();
}

TEST_P(Step, MoreThreadsThanIslands) {
    OdeSession::use(64, "lcp");
    EXPECT_EQ(sharedIn([&] { world.step(10); }).islands, 10 * kChains);
    expectSerialBits();
}

TEST_P(Step, ThreadsChangeBetweenSteps) {
    for (unsigned i = 0; i < 10; ++i) {
        OdeSession::use((i * 7) % 5, i % 3 == 0 ? "auto" : "lcp");
        if (i % 4 == 3 && !kThreadSanitizer) dODE_MT_SetThreadManager(i == 3 ? "openmp" : "pthread");
        world.step();
    }
    expectSerialBits();
}

TEST_P(Step, ThreadsChangeDuringSteps) {
    OdeSession::use(2, "lcp");
    std::atomic<bool> done{false};
    std::thread other([&done] {
        for (unsigned i = 0; !done; ++i) dToggleODE_MT(1 + i % 4);
    });
    world.step(10);
    done = true;
    other.join();
    expectSerialBits();
}

// From the first island with a callback on, islands are stepped in order on the calling thread.
TEST_P(Step, MovedCallbackIsCalledOnTheCallingThread) {
    static std::thread::id caller;
    caller = std::this_thread::get_id();
    g_movedCalls = 0;
    const auto moved = [](dBodyID) {
        ++g_movedCalls;
        EXPECT_EQ(std::this_thread::get_id(), caller);
    };
    for (const unsigned chain : {10u, 20u}) dBodySetMovedCallback(world.bodies()[chain * kLinks], moved);
    OdeSession::use(3, "lcp");
    // Upstream finds islands in the order opposite to that of the bodies' creation.
    EXPECT_EQ(sharedIn([&] { world.step(10); }).islands, 10 * (kChains - 21));
    EXPECT_EQ(g_movedCalls, 20u);
    expectSerialBits();
}

// Joints of two islands that share a feedback structure: the later island's numbers remain in it.
TEST_P(Step, SharedFeedbackIsThatOfTheLaterIsland) {
    dJointFeedback shared{}, sharedInSerial{};
    ChainWorld again(kChains, kLinks, GetParam());
    for (const unsigned chain : {3u, 11u, 25u}) {
        dJointSetFeedback(world.joints()[chain * kLinks], &shared);
        dJointSetFeedback(again.joints()[chain * kLinks], &sharedInSerial);
    }
    again.step(10);
    dRandSetSeed(9);
    OdeSession::use(3, "lcp");
    world.step(10);
    EXPECT_EQ(world.state(), again.state());
    for (int i = 0; i < 3; ++i) EXPECT_EQ(shared.f1[i], sharedInSerial.f1[i]);
    EXPECT_NE(shared.f1[2], 0);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Step, testing::Values(dWorldStep, dWorldQuickStep),
                         [](const auto &info) { return info.param == dWorldStep ? "world" : "quick"; });

}  // namespace
