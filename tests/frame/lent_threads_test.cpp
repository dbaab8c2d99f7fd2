// Threads that the program lends to the process serve steps and collisions, with serial bits, and are gone from the library when they are
// taken back.
//
// Covers api/ode_MT_workers.cpp.
#include "settings/dxLentThreads.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "ExecutorPool.h"
#include "HeapWorld.h"
#include "OdePool.h"
#include "OdeSession.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

std::vector<dReal> runHeap(int frames, HeapWorld::Callback callback = nullptr) {
    dRandSetSeed(1);
    HeapWorld heap(dHashSpaceCreate(nullptr));
    heap.setCallback(callback);
    for (int i = 0; i < frames; ++i) {
        heap.collide();
        heap.step();
    }
    return heap.positions();
}

class Executor : public testing::Test {
protected:
    void SetUp() override { dODE_MT_SetExecutor(ExecutorPool::post, &pool); }
    void TearDown() override {
        dODE_MT_SetExecutor(nullptr, nullptr);
        dODE_MT_SetCallbackPolicy("serial");
    }

    const OdeSession session{3, "lcp"};
    ExecutorPool pool{2};
};

TEST_F(Executor, ServesSteps) {
    ChainWorld world(40, 4), serial(40, 4);
    EXPECT_STREQ(dODE_MT_GetThreadManager(), "user");
    dODE_MT_SetWorldThreads(serial.world(), 1);
    dRandSetSeed(2);
    serial.step(20);
    dRandSetSeed(2);
    const unsigned before = dODE_MT_GetParallelSteps(), threadsBefore = processThreads();
    world.step(20);
    EXPECT_EQ(dODE_MT_GetParallelSteps(), before + 20);
    EXPECT_EQ(world.state(), serial.state());
    EXPECT_GT(pool.posted(), 0u);
    EXPECT_LE(pool.longestQueue(), 1u) << "at most one call waits";
    EXPECT_EQ(processThreads(), threadsBefore) << "the library starts none";
}

TEST_F(Executor, ServesCollisions) {
    const std::vector<dReal> lent = runHeap(15);
    EXPECT_GT(pool.posted(), 0u);
    OdeSession::use(0, "serial");
    EXPECT_EQ(lent, runHeap(15));
    OdeSession::use(3, "lcp");
}

std::atomic<int> g_callbacksOnThePool{0};

TEST_F(Executor, RunsConcurrentCallbacks) {
    g_callbacksOnThePool = 0;
    dODE_MT_SetCallbackPolicy("independent");
    const auto callback = [](HeapWorld &heap, dGeomID o1, dGeomID o2) {
        g_callbacksOnThePool += ExecutorPool::isOne();
        heap.makeContacts(o1, o2);
    };
    EXPECT_TRUE(waitUntil(
        [&] {
            runHeap(20, callback);
            return g_callbacksOnThePool > 0;
        },
        30));
    const std::vector<dReal> lent = runHeap(15, callback);
    dODE_MT_SetCallbackPolicy("serial");
    OdeSession::use(0, "serial");
    EXPECT_EQ(lent, runHeap(15));
    OdeSession::use(3, "lcp");
}

TEST_F(Executor, NoMoreThreadsThanAreSet) {
    OdeSession::use(2, "lcp");
    ExecutorPool large(6);
    dODE_MT_SetExecutor(ExecutorPool::post, &large);
    std::vector<std::thread> users;
    for (int i = 0; i < 3; ++i)
        users.emplace_back([] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            ChainWorld(40, 4).step(50);
            dCleanupODEAllDataForThread();
        });
    for (std::thread &user : users) user.join();
    EXPECT_LE(large.mostAtOnce(), 1u) << "beside the calling one";
    dODE_MT_SetExecutor(nullptr, nullptr);
}

TEST_F(Executor, WorldsHaveNumbersOfTheirOwn) {
    OdeSession::use(0, "lcp");
    ChainWorld world(40, 4);
    world.step(5);
    EXPECT_EQ(pool.posted(), 0u);
    dODE_MT_SetWorldThreads(world.world(), 3);
    const unsigned before = dODE_MT_GetParallelSteps();
    world.step(5);
    EXPECT_EQ(dODE_MT_GetParallelSteps(), before + 5);
    EXPECT_GT(pool.posted(), 0u);
}

TEST_F(Executor, ExchangedAndTakenBack) {
    ChainWorld world(40, 4);
    for (int i = 0; i < 20; ++i) {
        auto other = std::make_unique<ExecutorPool>(2);
        dODE_MT_SetExecutor(ExecutorPool::post, other.get());
        world.step(3);
        if (i % 3 == 0) dODE_MT_SetExecutor(nullptr, nullptr);
        if (i % 3 == 1) dODE_MT_SetThreadManager("pthread");
        if (i % 3 == 2) dODE_MT_SetExecutor(ExecutorPool::post, &pool);
        other.reset();
        EXPECT_STREQ(dODE_MT_GetThreadManager(), i % 3 == 2 ? "user" : "pthread");
        world.step();
    }
}

// An executor without threads, and one whose only thread is busy: the calling thread does all.
TEST_F(Executor, WhoseThreadsDoNotCome) {
    struct Waiting {
        dODE_MT_Work *work = nullptr;
        void *data = nullptr;
        int posted = 0;
    } waiting;
    dODE_MT_SetExecutor([](void *of, dODE_MT_Work *work, void *data) { *static_cast<Waiting *>(of) = {work, data, 1}; }, &waiting);
    ChainWorld world(40, 4);
    world.step(20);
    ASSERT_EQ(waiting.posted, 1);
    const Stopwatch watch;
    dODE_MT_SetExecutor(nullptr, nullptr);
    EXPECT_LT(watch.seconds(), 5);
    waiting.work(waiting.data);  // late: finds nothing
    world.step();
}

// An executor that keeps what it is given, for whoever calls it.
struct Kept {
    struct Piece {
        dODE_MT_Work *work;
        void *data;
    };

    static void post(void *kept, dODE_MT_Work *work, void *data) { static_cast<Kept *>(kept)->pieces.push_back({work, data}); }

    void call() {
        const std::vector<Piece> all = std::exchange(pieces, {});
        for (const Piece &piece : all) piece.work(piece.data);
    }

    std::vector<Piece> pieces;
};

// The program's mistake; the threads that are lent are counted right all the same.
TEST_F(Executor, ThatCallsTwice) {
    Kept kept;
    dODE_MT_SetExecutor(Kept::post, &kept);
    ChainWorld world(40, 4);
    world.step();
    ASSERT_EQ(kept.pieces.size(), 1u);
    kept.pieces.push_back(kept.pieces.front());
    kept.call();
    world.step();
    EXPECT_EQ(kept.pieces.size(), 1u);
    kept.call();
    const Stopwatch watch;
    dODE_MT_SetExecutor(nullptr, nullptr);
    EXPECT_LT(watch.seconds(), 0.5) << "nothing waits to be called";
}

// The queue is a part of the memory that the child has, too.
TEST_F(Executor, WhoseQueueIsCalledInAForkedChild) {
    Kept kept;
    dODE_MT_SetExecutor(Kept::post, &kept);
    ChainWorld world(40, 4);
    world.step();
    ASSERT_EQ(kept.pieces.size(), 1u);
    EXPECT_TRUE(support::trueInChild([&] {
        world.step();
        kept.call();
        world.step(5);
        const bool isAlone = kept.pieces.empty();
        const Stopwatch watch;
        dODE_MT_SetExecutor(Kept::post, &kept);
        const bool isWaited = watch.seconds() > 0.5;
        world.step();
        const bool isServed = kept.pieces.size() == 1;
        kept.call();
        dODE_MT_SetExecutor(nullptr, nullptr);
        return isAlone && isServed && !isWaited;
    }));
    kept.call();
    world.step();
    EXPECT_EQ(kept.pieces.size(), 1u);
    kept.call();
}

// Lent before the fork, used for the first time after it.
TEST_F(Executor, InAForkedChildIsNotAskedForWhatItWasLentToTheParentFor) {
    Kept kept;
    dODE_MT_SetExecutor(Kept::post, &kept);
    ChainWorld world(40, 4);
    EXPECT_TRUE(support::trueInChild([&] {
        world.step(5);
        return kept.pieces.empty();
    }));
    world.step();
    EXPECT_EQ(kept.pieces.size(), 1u);
    kept.call();
}

// One that calls at once, on the posting thread.
TEST_F(Executor, ThatDoesNotWaitForAnotherThread) {
    dODE_MT_SetExecutor([](void *, dODE_MT_Work *work, void *data) { work(data); }, nullptr);
    dRandSetSeed(3);
    ChainWorld world(40, 4);
    world.step(20);
    OdeSession::use(0, "serial");
    dRandSetSeed(3);
    ChainWorld serial(40, 4);
    serial.step(20);
    EXPECT_EQ(world.state(), serial.state());
    OdeSession::use(3, "lcp");
}

TEST_F(Executor, InAForkedChildTheCallerIsAloneUntilItLendsThreads) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer cannot start threads in the child";
    ChainWorld world(40, 4), other(40, 4);
    world.step(10);
    other.step(10);
    EXPECT_TRUE(support::trueInChild([&] {
        world.step(10);
        auto own = std::make_unique<ExecutorPool>(2);
        dODE_MT_SetExecutor(ExecutorPool::post, own.get());
        world.step(10);
        dODE_MT_SetExecutor(nullptr, nullptr);
        return own->posted() > 0;
    }));
    world.step(10);
}

TEST_F(Executor, HasLeftWhenTheLibraryIsClosed) {
    ChainWorld(40, 4).step(5);
    dCloseODE();
    dODE_MT_SetExecutor(nullptr, nullptr);
    dInitODE2(0);
}

TEST(ThreadingImplementation, ServesStepsAndCollisionsOfTheProcess) {
    if (kThreadSanitizer) GTEST_SKIP() << "ODE's pool has races of its own, which ThreadSanitizer reports";
    const OdeSession session(0, "lcp");
    const std::vector<dReal> expected = runHeap(15);
    OdeSession::use(3, "lcp");
    const OdePool pool;
    const unsigned threadsBefore = processThreads();
    ASSERT_EQ(dODE_MT_SetThreadingImplementation(dThreadingImplementationGetFunctions(pool.threading()), pool.threading()), 1);
    const unsigned collisions = dODE_MT_GetContactsAhead();
    EXPECT_EQ(runHeap(15), expected);
    EXPECT_GT(dODE_MT_GetContactsAhead(), collisions);
    {
        ChainWorld first(40, 4), second(40, 4);
        pool.lendTo(second.world());  // the same threads, to a world as well
        first.step(5);
        second.step(5);
        EXPECT_EQ(processThreads(), threadsBefore);
        OdePool::takeFrom(second.world());
        first.step(5);
    }
    EXPECT_EQ(dODE_MT_SetThreadingImplementation(nullptr, nullptr), 1);
    pool.shutDown();
    pool.freePool();
    pool.freeThreading();
}

TEST(ThreadingImplementation, IsWhole) {
    const OdeSession session;
    const dThreadingImplementationID threading = dThreadingAllocateSelfThreadedImplementation();
    testing::internal::CaptureStderr();
    EXPECT_EQ(dODE_MT_SetThreadingImplementation(nullptr, threading), 0);
    EXPECT_EQ(dODE_MT_SetThreadingImplementation(dThreadingImplementationGetFunctions(threading), nullptr), 0);
    const std::string messages = testing::internal::GetCapturedStderr();
    EXPECT_NE(messages.find("without functions (NULL)"), std::string::npos);
    EXPECT_NE(messages.find("without implementation (NULL)"), std::string::npos);
    EXPECT_STREQ(dODE_MT_GetThreadManager(), "pthread");
    OdeSession::use(3, "lcp");
    EXPECT_EQ(dODE_MT_SetThreadingImplementation(dThreadingImplementationGetFunctions(threading), threading), 1);
    ChainWorld(40, 4).step(5);  // it has no threads
    dODE_MT_SetThreadingImplementation(nullptr, nullptr);
    dThreadingFreeImplementation(threading);
}

}  // namespace
