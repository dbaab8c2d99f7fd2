// Messages and errors that islands report while they are stepped: delivered on the calling thread, in the
// order of a serial step, with the world as a serial step leaves it.
//
// Where a handler leaves with longjmp, the memory of the step is lost, as with upstream: in a child.
//
// A body that spins with NaN cannot be integrated: upstream reports an internal error from within its island.
//
// Covers dxDeferredIslands.cpp, dxIslandParallelStep.cpp, dxUpstreamScope.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <csetjmp>
#include <csignal>
#include <cstring>
#include <limits>
#include <thread>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "threading/dxSchedulePoints.h"

namespace {

constexpr unsigned kChains = 30, kLinks = 3;

std::thread::id g_caller;

// NaN compares equal to itself here.
bool sameBits(const std::vector<dReal> &a, const std::vector<dReal> &b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(dReal)) == 0;
}

void breakChain(ChainWorld &world, unsigned chain) {
    dBodySetAngularVel(world.bodies()[chain * kLinks], std::numeric_limits<dReal>::quiet_NaN(), 0, 0);
}

class Reports : public testing::TestWithParam<dWorldStepFunction *> {
protected:
    Reports() { g_caller = std::this_thread::get_id(); }
    ~Reports() override {
        dSetDebugHandler(nullptr);
        dxSetPerturbation(nullptr);
    }

    OdeSession session;
    ChainWorld world{kChains, kLinks, GetParam()}, serial{kChains, kLinks, GetParam()};
};

std::jmp_buf g_place;

// Steps until a handler leaves; returns whether it did.
bool stepUntilError(ChainWorld &world) {
    if (setjmp(g_place) != 0) return true;
    world.step();
    return false;
}

TEST_P(Reports, HandlerThatLeavesFindsTheWorldOfASerialStep) {
    EXPECT_TRUE(support::trueInChild([&] {
        static bool onCaller = true;
        dSetDebugHandler([](int, const char *, va_list) {
            onCaller = onCaller && std::this_thread::get_id() == g_caller;
            std::longjmp(g_place, 1);
        });
        for (const unsigned chain : {5u, 17u}) {
            breakChain(world, chain);
            breakChain(serial, chain);
        }
        OdeSession::use(0, "serial");
        dRandSetSeed(3);
        const bool serialLeft = stepUntilError(serial);
        const unsigned long seed = dRandGetSeed();
        OdeSession::use(4, "lcp");
        dxSetRandomPerturbation(2);
        dRandSetSeed(3);
        const bool left = stepUntilError(world);
        return serialLeft && left && onCaller && sameBits(world.state(), serial.state()) &&
               dRandGetSeed() == seed;
    }));
}

// A body without joints has no rows; it comes first, and its error leaves the step.
TEST_P(Reports, AnIslandWithoutEndIsNotBegunBeforeItsTurn) {
    EXPECT_TRUE(support::trueInChild([&] {
        const dBodyID first = dBodyCreate(world.world());
        dBodySetAngularVel(first, std::numeric_limits<dReal>::quiet_NaN(), 0, 0);
        dWorldSetQuickStepNumIterations(world.world(), -1);
        dSetDebugHandler([](int, const char *, va_list) { std::longjmp(g_place, 1); });
        OdeSession::use(0, "serial");
        const bool serialLeft = stepUntilError(world);
        OdeSession::use(4, "lcp");
        return serialLeft && stepUntilError(world);
    }));
}

TEST_P(Reports, HandlerMayThrow) {
    dSetDebugHandler([](int, const char *, va_list) { throw 1; });
    OdeSession::use(4, "lcp");
    breakChain(world, 7);
    EXPECT_THROW(world.step(), int);
    // Everything outside of that world continues.
    serial.step(3);
    ChainWorld other(kChains, kLinks, GetParam());
    OdeSession::use(0, "serial");
    other.step(3);
    if (GetParam() == dWorldStep) {
        EXPECT_EQ(serial.state(), other.state());
    }
}

TEST_P(Reports, WithoutAHandlerTheProcessEndsWithUpstreamsText) {
    breakChain(world, 7);
    const auto end = [&](int threads, const char *algorithm) {
        return support::runInChild([&] {
            OdeSession::use(threads, algorithm);
            world.step();
        });
    };
    const support::Ending serialEnd = end(0, "serial"), sharedEnd = end(4, "lcp");
    EXPECT_TRUE(serialEnd.killedBy(SIGABRT));
    EXPECT_TRUE(sharedEnd.killedBy(SIGABRT));
    EXPECT_NE(serialEnd.errors, "");
    EXPECT_EQ(sharedEnd.errors, serialEnd.errors);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Reports, testing::Values(dWorldStep, dWorldQuickStep),
                         [](const auto &info) { return info.param == dWorldStep ? "world" : "quick"; });

}  // namespace
