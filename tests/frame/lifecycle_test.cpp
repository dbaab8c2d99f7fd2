// dInitODE2 and dCloseODE: threads end with the last close and start again after the next use.
//
// Covers api/odeinit.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <csetjmp>
#include <csignal>
#include <string>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "OdeSession.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

struct Mode {
    const char *manager;
    int threads;
};

void PrintTo(const Mode &mode, std::ostream *out) { *out << mode.threads << " threads, " << mode.manager; }

class Lifecycle : public testing::TestWithParam<Mode> {
protected:
    void SetUp() override {
        skipIfUnseen(GetParam().manager);
        dODE_MT_SetThreadManager(GetParam().manager);
    }
    void TearDown() override { dODE_MT_SetThreadManager("pthread"); }
};

// Large enough that the threads of a second worker start in one of the steps.
std::vector<dReal> stepInParallel(int threads) {
    const OdeSession session(threads, "lcp");
    ChainWorld world(64, 5);
    dRandSetSeed(1);
    world.step(20);
    return world.state();
}

TEST_P(Lifecycle, CloseEndsAllThreads) {
    const bool ownThreads = GetParam().manager == std::string("pthread");
    stepInParallel(GetParam().threads);  // an OpenMP runtime may keep what its first use starts
    const unsigned before = processThreads();
    dInitODE2(0);
    dToggleODE_MT(GetParam().threads);
    dODE_MT_SetAlgorithm("lcp");
    {
        ChainWorld world(64, 5);
        const unsigned shared = dODE_MT_GetParallelSteps();
        world.step(20);
        EXPECT_EQ(dODE_MT_GetParallelSteps(), shared + 20);
        EXPECT_TRUE(processThreads() > before || !ownThreads);
    }
    dCloseODE();
    EXPECT_TRUE(threadsFallTo(before));
    OdeSession::use(0, "auto");
    EXPECT_EQ(processThreads(), before);
}

TEST_P(Lifecycle, WorksAgainAfterClosing) {
    const std::vector<dReal> serial = stepInParallel(0);
    stepInParallel(GetParam().threads);  // an OpenMP runtime may keep what its first use starts
    const unsigned before = processThreads();
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(stepInParallel(GetParam().threads), serial);
        EXPECT_TRUE(threadsFallTo(before));
    }
}

TEST_P(Lifecycle, OnlyTheLastCloseEndsThreads) {
    const OdeSession outer(GetParam().threads, "lcp");
    ChainWorld world(64, 5);
    world.step(20);
    const unsigned with = processThreads();
    dInitODE2(0);
    dCloseODE();
    EXPECT_EQ(processThreads(), with);
    world.step();
}

INSTANTIATE_TEST_SUITE_P(Managers, Lifecycle,
                         testing::Values(Mode{"pthread", 2}, Mode{"pthread", 5}, Mode{"openmp", 2},
                                         Mode{"openmp", 5}),
                         [](const auto &info) {
                             return info.param.manager + std::to_string(info.param.threads);
                         });

TEST(LifecycleErrors, CloseWithoutInitIsUpstreamsError) {
    const support::Ending end = support::runInChild([] { dCloseODE(); });
    EXPECT_TRUE(end.killedBy(SIGABRT));
    EXPECT_NE(end.errors.find("dCloseODE must not be called without dInitODE2"), std::string::npos)
        << end.errors;
}

// A debug handler that does not return leaves a library that can be used.
TEST(LifecycleErrors, HandlerMayLeave) {
    EXPECT_TRUE(support::trueInChild([] {
        static std::jmp_buf place;
        dSetDebugHandler([](int, const char *, va_list) { std::longjmp(place, 1); });
        if (setjmp(place) == 0) dCloseODE();
        dSetDebugHandler(nullptr);
        return stepInParallel(2) == stepInParallel(0);
    }));
}

TEST(LifecycleErrors, InitAndCloseWithoutAnyUse) {
    for (int i = 0; i < 100; ++i) {
        EXPECT_NE(dInitODE2(0), 0);
        dCloseODE();
    }
    dInitODE();
    dCloseODE();
}

}  // namespace
