// Settings of the process, and the calls that start and end the library's use, inside callbacks of all kinds: "at any
// time", says ode/ode_MT.h. Each child has 20 s.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "Deadline.h"
#include "OdePool.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

struct Call {
    const char *name;
    void (*make)();
};

void PrintTo(const Call &call, std::ostream *out) { *out << call.name; }

// With changing numbers, so that there is something to change.
int nextThreads() {
    static std::atomic<int> calls{0};
    return 2 + ++calls % 3;
}

const Call kCalls[] = {
    {"Toggle", [] { dToggleODE_MT(nextThreads()); }},
    {"ToggleOff", [] { dToggleODE_MT(0); }},
    {"ThreadManager", [] { dODE_MT_SetThreadManager(nextThreads() % 2 != 0 ? "openmp" : "pthread"); }},
    {"UnknownManager", [] { dODE_MT_SetThreadManager("none of these"); }},
    {"Algorithm", [] { dODE_MT_SetAlgorithm("decluster"); }},
    {"CallbackPolicy", [] { dODE_MT_SetCallbackPolicy("independent"); }},
    {"Heuristics", [] { dODE_MT_SetHeuristics("none"); }},
    {"GridCells", [] { dODE_MT_SetGridCells(7); }},
    {"InitAndClose", [] {
         dInitODE2(0);
         dCloseODE();
     }},
    {"LastClose", [] {
         static std::once_flag once;
         std::call_once(once, [] {
             dCloseODE();
             dInitODE2(0);
         });
     }},
    {"DataForThread", [] {
         dAllocateODEDataForThread(dAllocateMaskAll);
         dCleanupODEAllDataForThread();
     }},
    {"ThreadPool", [] {
         const OdePool pool(1);
         pool.shutDown();
         pool.freePool();
         pool.freeThreading();
     }},
};

class CallsInCallbacks : public testing::TestWithParam<Call> {
protected:
    void SetUp() override {
        const std::string name = GetParam().name;
        if (name == "ThreadManager") skipIfUnseen("openmp");
        if (kThreadSanitizer && name == "ThreadPool") GTEST_SKIP() << "upstream's pool has a race when it is shut down";
    }

    // Whether the frames were done, in a process of their own.
    static bool doneInChild(const std::function<void()> &frames) {
        const support::Ending end = support::runInChild([&frames] {
            dInitODE2(0);
            OdeSession::use(3, "lcp");
            frames();
        });
        if (!end.exitedWith(0)) std::fputs(end.errors.c_str(), stderr);
        return end.exitedWith(0);
    }
};

std::atomic<unsigned> g_callbacks;

void callAndCount(void *data, dGeomID, dGeomID) {
    static_cast<const Call *>(data)->make();
    ++g_callbacks;
}

void collide(const Call &call, const char *policy) {
    const SphereRows rows(dHashSpaceCreate(nullptr));
    g_callbacks = 0;
    for (unsigned frame = 1; frame <= 3; ++frame) {
        dODE_MT_SetCallbackPolicy(policy);
        dSpaceCollide(rows.space(), const_cast<Call *>(&call), callAndCount);
        if (g_callbacks != frame * SphereRows::kPairs) _exit(1);
    }
}

TEST_P(CallsInCallbacks, SerialNearCallback) {
    EXPECT_TRUE(doneInChild([] { collide(GetParam(), "serial"); }));
}

TEST_P(CallsInCallbacks, ConcurrentNearCallback) {
    EXPECT_TRUE(doneInChild([] { collide(GetParam(), "concurrent"); }));
}

const Call *g_call;

TEST_P(CallsInCallbacks, MovedCallback) {
    EXPECT_TRUE(doneInChild([] {
        g_call = &GetParam();
        ChainWorld world(40, 3);
        dBodySetMovedCallback(world.bodies()[60], [](dBodyID) { g_call->make(); });
        world.step(3);
    }));
}

TEST_P(CallsInCallbacks, MessageHandler) {
    EXPECT_TRUE(doneInChild([] {
        g_call = &GetParam();
        dSetMessageHandler([](int, const char *, va_list) {
            static thread_local bool isInside = false;
            if (isInside) return;  // the call may have a message of its own
            isInside = true;
            g_call->make();
            isInside = false;
        });
        for (int i = 0; i < 3; ++i) dToggleODE_MT(-1);
        const ChainWorld world(2, 2);
        dJointAttach(world.joints()[0], nullptr, nullptr);
    }));
}

TEST(CallsInSerialCallbacks, AnotherWorldIsMadeAndStepped) {
    constexpr Call kAnotherWorld{"AnotherWorld", [] { ChainWorld(8, 3).step(2); }};
    const OdeSession session(3, "lcp");
    collide(kAnotherWorld, "serial");
}

INSTANTIATE_TEST_SUITE_P(Calls, CallsInCallbacks, testing::ValuesIn(kCalls),
                         [](const auto &info) { return std::string(info.param.name); });

// Threads that step without a gap leave none for a change to wait for.
TEST(CallsDuringSteps, ChangesAreNotStarved) {
    const OdeSession session(2, "lcp");
    std::atomic<bool> enough{false};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&enough] {
            ChainWorld world(30, 3);
            while (!enough) world.step();
        });
    }
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 50; ++i) {
        dToggleODE_MT(2 + i % 3);
        dODE_MT_SetThreadManager("pthread");
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    enough = true;
    for (std::thread &thread : threads) thread.join();
}

// A manager that was exchanged in a callback ends its threads with the run that had it.
TEST(CallsDuringSteps, ThreadsOfAnExchangedManagerEnd) {
    const unsigned before = processThreads();
    {
        const OdeSession session(4, "lcp");
        dODE_MT_SetCallbackPolicy("concurrent");
        collide(kCalls[0], "concurrent");
        dToggleODE_MT(0);
        EXPECT_TRUE(threadsFallTo(before));
        dODE_MT_SetCallbackPolicy("serial");
    }
    EXPECT_TRUE(threadsFallTo(before));
}

}  // namespace
