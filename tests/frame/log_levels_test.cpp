// What ODE_MT_LOG shows of a program's frames at each level, as docs/settings.md says. (At debug: cost_model_test.cpp.)
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstdlib>

#include "ChainWorld.h"

namespace {

class LogLevels : public testing::Test {
protected:
    // The environment is read once in a process, so each needs one of its own.
    LogLevels() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }

    [[noreturn]] static void step(const char *level, const char *algorithm, unsigned steps) {
        setenv("ODE_MT_LOG", level, 1);
        setenv("ODE_MT_THREADS", "3", 1);
        setenv("ODE_MT_ALGORITHM", algorithm, 1);
        dInitODE2(0);
        {
            ChainWorld world(100, 5);
            world.step(steps);
        }
        dToggleODE_MT(2);
        dCloseODE();
        std::_Exit(0);
    }
};

TEST_F(LogLevels, WarningAndErrorAreQuiet) {
    EXPECT_EXIT(step("warning", "lcp", 3), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(step("error", "lcp", 3), testing::ExitedWithCode(0), "^$");
}

TEST_F(LogLevels, InfoNamesVersionsSettingsAndThreads) {
    EXPECT_EXIT(step("info", "lcp", 3), testing::ExitedWithCode(0),
                "^ODE_MT info: version " dODE_MT_VERSION ", made of ODE " dODE_VERSION "\n.*"
                "ODE_MT info: threads 3 of [0-9]+ cores, algorithm lcp, solver exact, callbacks serial, heuristics .*"
                "ODE_MT info: thread manager pthread: up to 3 threads, the caller included.*"
                "ODE_MT info: thread manager pthread: started ode_mt-1.*"
                "ODE_MT info: 2 threads, 3 before");
}

TEST_F(LogLevels, InfoSaysHowAWorldRuns) {
    const std::string line =
        "ODE_MT info: world 1, frame 1: 500 bodies, 0 pairs, 100 islands, [0-9]+ rows, 3 threads at most; no collision; step on one "
        "thread, as the algorithm is \"serial\"\n";
    EXPECT_EXIT(step("info", "serial", 200), testing::ExitedWithCode(0), "heuristics [^\n]*\n" + line + "ODE_MT info: 2 threads, 3 before[^\n]*\n$")
        << "once for all frames";
}

// The collision comes before the first step, and the space is too small for a timeline. A program may have stopped a trace before.
TEST_F(LogLevels, InfoCountsTheFirstCollisionOfASmallSpace) {
    const auto run = [](bool stopsTrace) {
        setenv("ODE_MT_LOG", "info", 1);
        dInitODE2(0);
        if (stopsTrace) dODE_MT_StopTrace();
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dHashSpaceCreate(nullptr);
        dCreatePlane(space, 0, 0, 1, 0);
        dGeomSetBody(dCreateSphere(space, 1), dBodyCreate(world));
        dSpaceCollide(space, nullptr, [](void *, dGeomID, dGeomID) {});
        dWorldStep(world, REAL(0.01));
        std::_Exit(0);
    };
    for (const bool stopsTrace : {false, true})
        EXPECT_EXIT(run(stopsTrace), testing::ExitedWithCode(0),
                    "world 1, frame 1: 1 bodies, 1 pairs, [^\n]*; pairs and near-callbacks on one thread");
}

// A change that does not last is not told.
TEST_F(LogLevels, InfoSaysWhenThatHasChanged) {
    const auto run = [] {
        setenv("ODE_MT_LOG", "info", 1);
        dInitODE2(0);
        ChainWorld world(4, 2);
        for (const char *const algorithm : {"lcp", "serial", "lcp", "serial"}) {
            dODE_MT_SetAlgorithm(algorithm);
            world.step(30);
        }
        world.step(30);
        std::_Exit(0);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0),
                "world 1, frame 1: [^\n]* as the number of threads is 0 or 1\n(ODE_MT info: [0-9][^\n]*\n)*"
                "ODE_MT info: world 1, frame 150: [^\n]* as the algorithm is \"serial\"\n$");
}

// Whoever asks for less does not pay for it.
TEST_F(LogLevels, InfoKeepsDebugBack) {
    const auto run = [] { step("info", "auto", 300); };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "ODE_MT info: [^\n]*(\nODE_MT info: [^\n]*)*\n$");
}

}  // namespace
