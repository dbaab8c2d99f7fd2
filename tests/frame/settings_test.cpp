// The number of threads, the algorithm and the thread manager, from calls and from the environment.
//
// Covers api/ode_MT.cpp, dxEnvironment.cpp, dxProcessors.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <sched.h>

#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <limits>
#include <string>
#include <thread>

#include "ChainWorld.h"
#include "OdeSession.h"

namespace {

int usableCores() {
    cpu_set_t set;
    sched_getaffinity(0, sizeof set, &set);
    return CPU_COUNT(&set);
}

std::string g_messages;

// Collects what dMessage says for as long as it lives.
class Messages {
public:
    Messages() {
        g_messages.clear();
        dSetMessageHandler([](int, const char *format, va_list arguments) {
            char text[500];
            std::vsnprintf(text, sizeof text, format, arguments);
            g_messages += std::string(text) + "\n";
        });
    }
    ~Messages() { dSetMessageHandler(nullptr); }
    bool tell(const std::string &what) const { return g_messages.find(what) != std::string::npos; }
    bool empty() const { return g_messages.empty(); }
};

class Settings : public testing::Test {
    OdeSession session;
};

TEST_F(Settings, ThreadsInRangeAreTakenSilently) {
    const Messages messages;
    for (const int threads : {0, 1, 2, 1024}) {
        dToggleODE_MT(threads);
        EXPECT_EQ(dODE_MT_GetThreads(), threads);
    }
    dToggleODE_MT(dODE_MT_AUTO);
    EXPECT_EQ(dODE_MT_GetThreads(), usableCores());
    EXPECT_TRUE(messages.empty()) << g_messages;
}

// Binds the calling thread to one processor for as long as it lives.
class Pinned {
public:
    Pinned() {
        sched_getaffinity(0, sizeof m_before, &m_before);
        int processor = 0;
        while (!CPU_ISSET(processor, &m_before)) ++processor;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(processor, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~Pinned() { sched_setaffinity(0, sizeof m_before, &m_before); }

private:
    cpu_set_t m_before;
};

TEST_F(Settings, AutoCountsTheProcessorsOfTheProcessNotOfTheThread) {
    const int cores = usableCores();
    if (cores < 2) GTEST_SKIP() << "one processor";
    {
        const Pinned firstThread;
        dToggleODE_MT(dODE_MT_AUTO);
        EXPECT_EQ(dODE_MT_GetThreads(), cores);
    }
    std::thread([cores] {
        const Pinned another;
        dToggleODE_MT(dODE_MT_AUTO);
        EXPECT_EQ(dODE_MT_GetThreads(), cores);
    }).join();
}

// The environment is read by the first call, which a thread may make that is bound to one processor.
TEST(SettingsDeathTest, AutoOfAPinnedFirstCall) {
    const int cores = usableCores();
    if (cores < 2) GTEST_SKIP() << "one processor";
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [cores](const char *threads) {
        setenv("ODE_MT_THREADS", threads, 1);
        const Pinned pinned;
        if (dODE_MT_GetThreads() != (*threads == 'a' ? cores : 0)) std::_Exit(1);
        dToggleODE_MT(dODE_MT_AUTO);
        std::_Exit(dODE_MT_GetThreads() == cores ? 0 : 2);
    };
    EXPECT_EXIT(run("auto"), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(run("0"), testing::ExitedWithCode(0), "");
}

// A process that is started with one processor and gets more later.
TEST(SettingsDeathTest, AutoIsAskedAnewAtEachCall) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [] {
        dToggleODE_MT(dODE_MT_AUTO);
        if (dODE_MT_GetThreads() != 1) std::_Exit(1);
        cpu_set_t all;
        CPU_ZERO(&all);
        for (int processor = 0; processor < CPU_SETSIZE; ++processor) CPU_SET(processor, &all);
        sched_setaffinity(0, sizeof all, &all);
        dToggleODE_MT(dODE_MT_AUTO);
        std::_Exit(dODE_MT_GetThreads() == usableCores() ? 0 : 2);
    };
    const Pinned pinned;  // which the process of its own inherits
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST_F(Settings, ThreadsOutOfRangeAreNamed) {
    for (const auto [asked, taken] :
         std::map<int, int>{{-5, 0}, {INT_MIN, 0}, {1025, 1024}, {INT_MAX - 1, 1024}}) {
        const Messages messages;
        dToggleODE_MT(asked);
        EXPECT_EQ(dODE_MT_GetThreads(), taken);
        EXPECT_TRUE(messages.tell(std::to_string(asked))) << g_messages;
        EXPECT_TRUE(messages.tell(std::to_string(taken))) << g_messages;
    }
}

TEST_F(Settings, KnownAlgorithmsAreTaken) {
    const Messages messages;
    for (const char *name : {"serial", "lcp", "auto"}) {
        EXPECT_EQ(dODE_MT_SetAlgorithm(name), 1);
        EXPECT_STREQ(dODE_MT_GetAlgorithm(), name);
    }
    EXPECT_TRUE(messages.empty()) << g_messages;
}

TEST_F(Settings, UnknownAlgorithmIsNamedAndChangesNothing) {
    dODE_MT_SetAlgorithm("lcp");
    for (const char *name : {"foo", "", "LCP", static_cast<const char *>(nullptr)}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetAlgorithm(name), 0);
        EXPECT_STREQ(dODE_MT_GetAlgorithm(), "lcp");
        EXPECT_TRUE(messages.tell("'" + std::string(name ? name : "(null)") + "'")) << g_messages;
        EXPECT_TRUE(messages.tell("auto, serial, lcp")) << g_messages;
    }
}

TEST_F(Settings, SolversAreOfOneWorld) {
    const Messages messages;
    const dWorldID chosen = dWorldCreate(), other = dWorldCreate();
    EXPECT_STREQ(dODE_MT_GetSolver(chosen), "exact");
    for (const char *name : {"fast", "exact", "fast"}) {
        EXPECT_EQ(dODE_MT_SetSolver(chosen, name), 1);
        EXPECT_STREQ(dODE_MT_GetSolver(chosen), name);
        EXPECT_STREQ(dODE_MT_GetSolver(other), "exact");
    }
    EXPECT_TRUE(messages.empty()) << g_messages;
    dWorldDestroy(chosen);
    dWorldDestroy(other);
}

// The allocator places some of many new worlds where that one was.
TEST_F(Settings, SolverEndsWithItsWorld) {
    const dWorldID destroyed = dWorldCreate();
    dODE_MT_SetSolver(destroyed, "fast");
    dWorldDestroy(destroyed);
    for (int i = 0; i < 20; ++i) {
        const dWorldID world = dWorldCreate();
        EXPECT_STREQ(dODE_MT_GetSolver(world), "exact");
        dWorldDestroy(world);
    }
}

TEST_F(Settings, UnknownSolverIsNamedAndChangesNothing) {
    const dWorldID world = dWorldCreate();
    dODE_MT_SetSolver(world, "fast");
    for (const char *name : {"foo", "", "FAST", static_cast<const char *>(nullptr)}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetSolver(world, name), 0);
        EXPECT_STREQ(dODE_MT_GetSolver(world), "fast");
        EXPECT_TRUE(messages.tell("'" + std::string(name ? name : "(null)") + "'")) << g_messages;
        EXPECT_TRUE(messages.tell("exact, fast")) << g_messages;
    }
    dWorldDestroy(world);
}

TEST_F(Settings, SettingsOfFastQuickStepAreOfOneWorld) {
    const Messages messages;
    const dWorldID chosen = dWorldCreate(), other = dWorldCreate();
    const double usual = dODE_MT_GetSolverTolerance(chosen);
    for (const double tolerance : {0.0, 0.25, 1.0}) {
        EXPECT_EQ(dODE_MT_SetSolverTolerance(chosen, tolerance), 1);
        EXPECT_EQ(dODE_MT_GetSolverTolerance(chosen), tolerance);
        EXPECT_EQ(dODE_MT_GetSolverTolerance(other), usual);
    }
    EXPECT_EQ(dODE_MT_GetWarmStart(chosen), 1);
    dODE_MT_SetWarmStart(chosen, 0);
    EXPECT_EQ(dODE_MT_GetWarmStart(chosen), 0);
    dODE_MT_SetWarmStart(chosen, -3);
    EXPECT_EQ(dODE_MT_GetWarmStart(chosen), 1);
    EXPECT_STREQ(dODE_MT_GetSolver(chosen), "exact");
    EXPECT_TRUE(messages.empty()) << g_messages;
    dWorldDestroy(chosen);
    dWorldDestroy(other);
}

TEST_F(Settings, ImpossibleTolerancesAreNamedAndChangeNothing) {
    const dWorldID world = dWorldCreate();
    dODE_MT_SetSolverTolerance(world, 0.5);
    for (const double tolerance : {-1e-9, 1.5, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetSolverTolerance(world, tolerance), 0);
        EXPECT_EQ(dODE_MT_GetSolverTolerance(world), 0.5);
        EXPECT_TRUE(messages.tell("no solver tolerance")) << g_messages;
    }
    dWorldDestroy(world);
}

TEST(SettingsDeathTest, SolverOfNoWorldIsAnError) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(dODE_MT_SetSolverTolerance(nullptr, 0.5), "bad world argument in dODE_MT_SetSolverTolerance");
    EXPECT_DEATH(dODE_MT_GetSolverTolerance(nullptr), "bad world argument in dODE_MT_GetSolverTolerance");
    EXPECT_DEATH(dODE_MT_SetWarmStart(nullptr, 0), "bad world argument in dODE_MT_SetWarmStart");
    EXPECT_DEATH(dODE_MT_GetWarmStart(nullptr), "bad world argument in dODE_MT_GetWarmStart");
    EXPECT_DEATH(dODE_MT_SetSolver(nullptr, "fast"), "bad world argument in dODE_MT_SetSolver");
    EXPECT_DEATH(dODE_MT_GetSolver(nullptr), "bad world argument in dODE_MT_GetSolver");
}

TEST(SettingsDeathTest, SolverOfTheEnvironmentIsThatOfNewWorlds) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [](const char *value, const std::string &expected) {
        setenv("ODE_MT_SOLVER", value, 1);
        dInitODE2(0);
        const dWorldID world = dWorldCreate(), other = dWorldCreate();
        const bool isExpected = dODE_MT_GetSolver(world) == expected;
        dODE_MT_SetSolver(world, "exact");
        const bool isOwn = std::string(dODE_MT_GetSolver(world)) == "exact" && dODE_MT_GetSolver(other) == expected;
        std::_Exit(!isExpected ? 1 : !isOwn ? 2 : 0);
    };
    EXPECT_EXIT(run("fast", "fast"), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("exact", "exact"), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("", "exact"), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("foo", "exact"), testing::ExitedWithCode(0), "ODE_MT_SOLVER is 'foo'.*exact, fast; exact is taken");
}

TEST(SettingsDeathTest, SettingsOfFastQuickStepAreReadFromTheEnvironment) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [](const char *tolerance, const char *warmStart, double expectedTolerance, int expectedWarmStart) {
        setenv("ODE_MT_SOLVER_TOLERANCE", tolerance, 1);
        setenv("ODE_MT_WARM_START", warmStart, 1);
        dInitODE2(0);
        const dWorldID world = dWorldCreate();
        if (expectedTolerance >= 0 && dODE_MT_GetSolverTolerance(world) != expectedTolerance) std::_Exit(1);
        std::_Exit(dODE_MT_GetWarmStart(world) == expectedWarmStart ? 0 : 2);
    };
    EXPECT_EXIT(run("0.25", "0", 0.25, 0), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("1e-3", "1", 1e-3, 1), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("", "", -1, 1), testing::ExitedWithCode(0), "^$");
    EXPECT_EXIT(run("2", "", -1, 1), testing::ExitedWithCode(0), "ODE_MT_SOLVER_TOLERANCE is '2'; known: a number from 0 to 1; 1e-09 is taken");
    EXPECT_EXIT(run("0.5x", "", -1, 1), testing::ExitedWithCode(0), "ODE_MT_SOLVER_TOLERANCE is '0.5x'");
    EXPECT_EXIT(run("", "yes", -1, 1), testing::ExitedWithCode(0), "ODE_MT_WARM_START is 'yes'; known: 0, 1; 1 is taken");
    EXPECT_EXIT(run("", "-1", -1, 0), testing::ExitedWithCode(0), "ODE_MT_WARM_START is '-1'; known: 0, 1; 0 is taken");
}

TEST_F(Settings, HeuristicsAreTakenByName) {
    const Messages messages;
    for (const char *names : {"none", "cells", "centre,threads", "cells,centre,crossover,declustering,threads"}) {
        EXPECT_EQ(dODE_MT_SetHeuristics(names), 1);
        EXPECT_STREQ(dODE_MT_GetHeuristics(), names);
    }
    EXPECT_EQ(dODE_MT_SetHeuristics("default"), 1);
    EXPECT_STREQ(dODE_MT_GetHeuristics(), "cells,centre,crossover,declustering");
    EXPECT_TRUE(messages.empty()) << g_messages;
}

TEST_F(Settings, UnknownHeuristicsAreNamedAndChangeNothing) {
    dODE_MT_SetHeuristics("cells");
    for (const char *names : {"foo", "", ",", "cells,", ",cells", "cells,foo", "cells,none", static_cast<const char *>(nullptr)}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetHeuristics(names), 0);
        EXPECT_STREQ(dODE_MT_GetHeuristics(), "cells");
        EXPECT_TRUE(messages.tell("'" + std::string(names ? names : "(null)") + "'")) << g_messages;
        EXPECT_TRUE(messages.tell("default, none, cells")) << g_messages;
    }
    dODE_MT_SetHeuristics("default");
}

TEST_F(Settings, GridCellsInRangeAreTakenSilently) {
    const Messages messages;
    for (const int cells : {5, 20, 0}) {
        EXPECT_EQ(dODE_MT_SetGridCells(cells), 1);
        EXPECT_EQ(dODE_MT_GetGridCells(), cells);
    }
    EXPECT_TRUE(messages.empty()) << g_messages;
}

TEST_F(Settings, GridCellsOutOfRangeAreNamedAndChangeNothing) {
    dODE_MT_SetGridCells(8);
    for (const int cells : {-1, 4, 21, INT_MAX, INT_MIN}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetGridCells(cells), 0);
        EXPECT_EQ(dODE_MT_GetGridCells(), 8);
        EXPECT_TRUE(messages.tell(std::to_string(cells))) << g_messages;
        EXPECT_TRUE(messages.tell("5 to 20")) << g_messages;
    }
    dODE_MT_SetGridCells(0);
}

TEST_F(Settings, UnknownThreadManagerIsNamedAndChangesNothing) {
    for (const char *name : {"foo", "", static_cast<const char *>(nullptr)}) {
        const Messages messages;
        EXPECT_EQ(dODE_MT_SetThreadManager(name), 0);
        EXPECT_STREQ(dODE_MT_GetThreadManager(), "pthread");
        EXPECT_TRUE(messages.tell("'" + std::string(name ? name : "(null)") + "'")) << g_messages;
        EXPECT_TRUE(messages.tell("pthread, openmp")) << g_messages;
    }
}

TEST_F(Settings, ThreadManagersAreExchanged) {
    dToggleODE_MT(3);
    for (const char *name : {"openmp", "pthread"}) {
        EXPECT_EQ(dODE_MT_SetThreadManager(name), 1);
        EXPECT_STREQ(dODE_MT_GetThreadManager(), name);
    }
}

// --- the environment: read once in a process, so each case runs in one of its own ------------------------

struct Case {
    std::string variable, value;
    std::string says;  // a regular expression for standard error
    int threads;
    std::string algorithm, manager;
    int gridCells = 0;
};

void PrintTo(const Case &c, std::ostream *out) { *out << c.variable << "=" << c.value; }

class Environment : public testing::TestWithParam<Case> {
protected:
    Environment() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }

    // Steps a world first, as a program does that cannot be recompiled; ends with 0 if it stepped as a
    // world does in a process without any of the variables and the settings are as they should be.
    [[noreturn]] void stepAndCompare() const {
        setenv(GetParam().variable.c_str(), GetParam().value.c_str(), 1);
        dInitODE2(0);
        ChainWorld world(20, 3);
        dRandSetSeed(0);
        world.step(5);
        const bool settings = dODE_MT_GetThreads() == GetParam().threads &&
                              dODE_MT_GetAlgorithm() == GetParam().algorithm &&
                              dODE_MT_GetThreadManager() == GetParam().manager &&
                              dODE_MT_GetGridCells() == GetParam().gridCells;
        OdeSession::use(0, "serial");
        ChainWorld serial(20, 3);
        dRandSetSeed(0);
        serial.step(5);
        std::_Exit(!settings ? 1 : world.state() != serial.state() ? 2 : 0);
    }
};

TEST_P(Environment, IsUnderstoodOrNamed) {
    EXPECT_EXIT(stepAndCompare(), testing::ExitedWithCode(0), GetParam().says);
}

const Case kCases[] = {
    {"ODE_MT_THREADS", "3", "^$", 3, "auto", "pthread"},
    {"ODE_MT_THREADS", "auto", "^$", usableCores(), "auto", "pthread"},
    {"ODE_MT_THREADS", "abc", "ODE_MT_THREADS is 'abc'.*auto.*0 to 1024", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "3 4", "ODE_MT_THREADS is '3 4'.*auto.*0 to 1024", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "-3", "ODE_MT_THREADS.*-3.*0", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "1025", "ODE_MT_THREADS.*1025.*1024", 1024, "auto", "pthread"},
    {"ODE_MT_THREADS", "2147483647", "ODE_MT_THREADS.*2147483647.*1024", 1024, "auto", "pthread"},
    {"ODE_MT_THREADS", "99999999999999", "ODE_MT_THREADS.*99999999999999.*1024", 1024, "auto", "pthread"},
    {"ODE_MT_THREADS", "99999999999999999999", "ODE_MT_THREADS.*99999999999999999999.*1024", 1024, "auto",
     "pthread"},
    {"ODE_MT_ALGORITHM", "lcp", "^$", 0, "lcp", "pthread"},
    {"ODE_MT_ALGORITHM", "foo", "ODE_MT_ALGORITHM.*'foo'.*auto, serial, lcp", 0, "auto", "pthread"},
    {"ODE_MT_HEURISTICS", "cells,threads", "^$", 0, "auto", "pthread"},
    {"ODE_MT_HEURISTICS", "foo", "ODE_MT_HEURISTICS.*'foo'.*default, none.*cells,centre", 0, "auto", "pthread"},
    {"ODE_MT_GRID_CELLS", "12", "^$", 0, "auto", "pthread", 12},
    {"ODE_MT_GRID_CELLS", "auto", "^$", 0, "auto", "pthread"},
    {"ODE_MT_GRID_CELLS", "4", "ODE_MT_GRID_CELLS.*'4'.*auto.*5 to 20; 5", 0, "auto", "pthread", 5},
    {"ODE_MT_GRID_CELLS", "0", "ODE_MT_GRID_CELLS.*'0'.*auto.*5 to 20; 5", 0, "auto", "pthread", 5},
    {"ODE_MT_GRID_CELLS", "9 9", "ODE_MT_GRID_CELLS.*'9 9'.*auto.*5 to 20", 0, "auto", "pthread"},
    {"ODE_MT_GRID_CELLS", "99999999999999999999", "ODE_MT_GRID_CELLS.*5 to 20; 20", 0, "auto", "pthread", 20},
    {"ODE_MT_THREAD_MANAGER", "openmp", "^$", 0, "auto", "openmp"},
    {"ODE_MT_WORKERS", "none", "^$", 0, "auto", "pthread"},
    {"ODE_MT_WORKERS", "pvm", "ODE_MT_WORKERS is 'pvm'.*none, mpi, mpi:n.*1 to 1024; none", 0, "auto", "pthread"},
    {"ODE_MT_WORKERS", "mpi:0", "ODE_MT_WORKERS is 'mpi:0'.*none, mpi, mpi:n", 0, "auto", "pthread"},
    {"ODE_MT_WORKERS", "mpi:", "ODE_MT_WORKERS is 'mpi:'.*none, mpi, mpi:n", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", " 3", "ODE_MT_THREADS is ' 3'.*auto.*0 to 1024; 0", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "-0", "ODE_MT_THREADS is '-0'.*auto.*0 to 1024; 0", 0, "auto", "pthread"},
    {"ODE_MT_THREADS", "+3", "ODE_MT_THREADS is '[+]3'.*auto.*0 to 1024; 0", 0, "auto", "pthread"},
    {"ODE_MT_GRID_CELLS", " 9", "ODE_MT_GRID_CELLS is ' 9'.*auto.*5 to 20; auto", 0, "auto", "pthread"},
    // Empty is unset, for all of them.
    {"ODE_MT_ALGORITHM", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_CALLBACKS", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_HEURISTICS", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_GRID_CELLS", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_WORKERS", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_THREAD_MANAGER", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_LOG", "", "^$", 0, "auto", "pthread"},
    // Names that are not the library's.
    {"ODE_MT_THREAD", "2", "ODE_MT warning: ODE_MT_THREAD is no variable of this library.*is ODE_MT_THREADS meant", 0, "auto", "pthread"},
    {"ODE_MT_THRAEDS", "2", "is ODE_MT_THREADS meant", 0, "auto", "pthread"},
    {"ODEMT_THREADS", "2", "ODEMT_THREADS is no variable.*is ODE_MT_THREADS meant", 0, "auto", "pthread"},
    {"ode_mt_threads", "2", "ode_mt_threads is no variable.*is ODE_MT_THREADS meant", 0, "auto", "pthread"},
    {"ODE_MT_CALLBACK", "concurrent", "is ODE_MT_CALLBACKS meant", 0, "auto", "pthread"},
    {"ODE_MT_THREADMANAGER", "openmp", "is ODE_MT_THREAD_MANAGER meant", 0, "auto", "pthread"},
    {"ODE_MT_SOLVER_TOLERANZ", "1", "is ODE_MT_SOLVER_TOLERANCE meant", 0, "auto", "pthread"},
    {"ODE_MT_LOGS", "info", "is ODE_MT_LOG meant", 0, "auto", "pthread"},
    {"ODE_MT_COLOUR", "red", "ODE_MT_COLOUR is no variable of this library, and has no effect\n$", 0, "auto", "pthread"},
    {"ODE_MT_", "1", "ODE_MT_ is no variable of this library, and has no effect\n$", 0, "auto", "pthread"},
    {"ODE_MT_COLOUR", "", "^$", 0, "auto", "pthread"},
    {"ODE_MT_WORLDS", "folder", "^$", 0, "auto", "pthread"},
    {"ODEMT_COLOUR", "red", "^$", 0, "auto", "pthread"},
    {"ODE_THREADS", "2", "^$", 0, "auto", "pthread"},
    {"ODE_MT_THREAD_MANAGER", "foo", "ODE_MT_THREAD_MANAGER.*'foo'.*pthread, openmp", 0, "auto", "pthread"},
};

INSTANTIATE_TEST_SUITE_P(Values, Environment, testing::ValuesIn(kCases), [](const auto &info) {
    return std::to_string(info.index) + "_" + info.param.variable;
});

// A message handler that calls back, or leaves, while the environment is read finds a library that works.
TEST(EnvironmentHandler, MayCallBack) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [] {
        alarm(20);
        setenv("ODE_MT_THREADS", "abc", 1);
        setenv("ODE_MT_ALGORITHM", "foo", 1);
        dInitODE2(0);
        dSetMessageHandler([](int, const char *, va_list) { dToggleODE_MT(dODE_MT_GetThreads()); });
        ChainWorld world(20, 3);
        world.step();
        dToggleODE_MT(2);
        std::_Exit(dODE_MT_GetThreads() == 2 ? 0 : 1);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(EnvironmentHandler, MayThrow) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [] {
        alarm(20);
        setenv("ODE_MT_THREADS", "abc", 1);
        dInitODE2(0);
        dSetMessageHandler([](int, const char *, va_list) { throw 1; });
        ChainWorld world(20, 3);
        try {
            world.step();
        } catch (int) {
        }
        dToggleODE_MT(2);
        std::_Exit(dODE_MT_GetThreads() == 2 ? 0 : 1);
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

}  // namespace
