// Callbacks that run at the same time have different indices below dODE_MT_GetWorkerCount, with every policy and every kind of threads; so
// buffers by index need no lock.
//
// Covers api/ode_MT_workers.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "ExecutorPool.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

// Who has an index at the moment.
struct Users {
    std::vector<std::atomic<int>> inUse = std::vector<std::atomic<int>>(dODE_MT_MAX_THREADS);
    std::atomic<int> calls{0}, shared{0}, outOfRange{0}, wrongCaller{0};
    int count = 0;
    pthread_t caller = pthread_self();
    std::mutex mutex;
    std::set<int> seen;

    static void meet(void *data, dGeomID o1, dGeomID o2) {
        Users &users = *static_cast<Users *>(data);
        const int index = dODE_MT_GetWorkerIndex();
        ++users.calls;
        if (index < 0 || index >= users.count) {
            ++users.outOfRange;
            return;
        }
        if ((index == 0) != (pthread_equal(pthread_self(), users.caller) != 0)) ++users.wrongCaller;
        if (users.inUse[index].exchange(1) != 0) ++users.shared;
        dContactGeom contact;
        dCollide(o1, o2, 1, &contact, sizeof contact);
        const timespec pause{0, 20000};  // so that others come
        nanosleep(&pause, nullptr);
        if (dODE_MT_GetWorkerIndex() != index) ++users.wrongCaller;
        users.inUse[index] = 0;
        const std::lock_guard<std::mutex> hold(users.mutex);
        users.seen.insert(index);
    }

    void collide(dSpaceID space) {
        count = dODE_MT_GetWorkerCount(space);
        dSpaceCollide(space, this, meet);
    }
    void expectRight() const {
        EXPECT_GT(calls, 0);
        EXPECT_EQ(shared, 0);
        EXPECT_EQ(outOfRange, 0);
        EXPECT_EQ(wrongCaller, 0);
    }
};

// By name: a thread manager, or an executor.
class WorkerIndex : public testing::TestWithParam<const char *> {
protected:
    void SetUp() override {
        if (kThreadSanitizer && std::string(GetParam()) == "openmp") GTEST_SKIP() << "its synchronisation is not seen";
        if (std::string(GetParam()) == "executor")
            dODE_MT_SetExecutor(ExecutorPool::post, &pool);
        else
            ASSERT_EQ(dODE_MT_SetThreadManager(GetParam()), 1);
    }
    void TearDown() override {
        dODE_MT_SetThreadManager("pthread");
        dODE_MT_SetCallbackPolicy("serial");
    }

    const OdeSession session{3, "lcp"};
    ExecutorPool pool{2};
};

TEST_P(WorkerIndex, IsOneThreadsAtATime) {
    for (const char *policy : {"concurrent", "independent"}) {
        dODE_MT_SetCallbackPolicy(policy);
        const SphereRows rows(dHashSpaceCreate(nullptr));
        EXPECT_EQ(dODE_MT_GetWorkerCount(rows.space()), 3);
        Users users;
        EXPECT_TRUE(waitUntil(
            [&] {
                users.collide(rows.space());
                return users.seen.size() >= 2;
            },
            30))
            << policy;
        users.expectRight();
        EXPECT_EQ(*users.seen.begin(), 0);
    }
    EXPECT_EQ(dODE_MT_GetWorkerIndex(), 0) << "outside of callbacks";
}

TEST_P(WorkerIndex, IsZeroOneAtATime) {
    const SphereRows rows(dHashSpaceCreate(nullptr));
    Users users;
    users.collide(rows.space());
    users.expectRight();
    EXPECT_EQ(users.seen, std::set<int>{0});
}

TEST_P(WorkerIndex, IsBelowTheSpacesOwnNumber) {
    dODE_MT_SetCallbackPolicy("independent");
    const SphereRows rows(dHashSpaceCreate(nullptr));
    for (const int threads : {2, 1, 8}) {
        dODE_MT_SetSpaceThreads(rows.space(), threads);
        EXPECT_EQ(dODE_MT_GetWorkerCount(rows.space()), threads);
        Users users;
        for (int i = 0; i < 10; ++i) users.collide(rows.space());
        users.expectRight();
    }
    dODE_MT_SetAlgorithm("serial");
    EXPECT_EQ(dODE_MT_GetWorkerCount(rows.space()), 1);
    dODE_MT_SetAlgorithm("auto");
    EXPECT_GE(dODE_MT_GetWorkerCount(rows.space()), 1);
}

// A callback collides the geoms of a nested space with another: those callbacks have the index of this one.
TEST_P(WorkerIndex, IsThatOfTheOuterCallback) {
    dODE_MT_SetCallbackPolicy("independent");
    const dSpaceID outer = dSimpleSpaceCreate(nullptr);
    std::vector<dSpaceID> inner;
    for (int i = 0; i < 24; ++i) {
        inner.push_back(dSimpleSpaceCreate(outer));
        for (int k = 0; k < 3; ++k) dGeomSetPosition(dCreateSphere(inner.back(), 1), 10 * (i / 2), dReal(0.5) * k, i % 2);
    }
    struct Nested {
        std::atomic<int> calls{0}, wrong{0};
        static void meet(void *data, dGeomID o1, dGeomID o2) {
            Nested &nested = *static_cast<Nested *>(data);
            if (!dGeomIsSpace(o1)) return;
            struct Inner {
                Nested &nested;
                int index;
            } of{nested, dODE_MT_GetWorkerIndex()};
            dSpaceCollide2(o1, o2, &of, [](void *innerData, dGeomID, dGeomID) {
                const Inner &own = *static_cast<Inner *>(innerData);
                ++own.nested.calls;
                own.nested.wrong += dODE_MT_GetWorkerIndex() != own.index;
            });
        }
    } nested;
    for (int i = 0; i < 10; ++i) dSpaceCollide(outer, &nested, Nested::meet);
    EXPECT_GT(nested.calls, 0);
    EXPECT_EQ(nested.wrong, 0);
    dSpaceDestroy(outer);
}

INSTANTIATE_TEST_SUITE_P(With, WorkerIndex, testing::Values("pthread", "openmp", "executor"), [](const auto &info) { return info.param; });

}  // namespace
