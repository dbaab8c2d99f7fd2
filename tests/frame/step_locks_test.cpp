// A step of a small world on one thread takes no mutex: what is kept beside the world is found without one, and what steps keep for one another is
// borrowed without one.
//
// A program of its own, because it puts its functions in the place of the C library's.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

std::atomic<bool> g_counting{false};
std::atomic<unsigned> g_locks{0};

#if !defined(ODE_MT_ADDRESS_SANITIZER) && !defined(ODE_MT_THREAD_SANITIZER)
using Function = int (*)(pthread_mutex_t *);

int lock(std::atomic<Function> &known, const char *name, pthread_mutex_t *mutex) {
    if (g_counting.load(std::memory_order_relaxed)) g_locks.fetch_add(1, std::memory_order_relaxed);
    Function function = known.load(std::memory_order_relaxed);
    if (function == nullptr) known.store(function = reinterpret_cast<Function>(dlsym(RTLD_NEXT, name)), std::memory_order_relaxed);
    return function(mutex);
}

std::atomic<Function> g_lock{nullptr}, g_tryLock{nullptr};
#endif

}  // namespace

#if !defined(ODE_MT_ADDRESS_SANITIZER) && !defined(ODE_MT_THREAD_SANITIZER)
extern "C" {
int pthread_mutex_lock(pthread_mutex_t *mutex) { return lock(g_lock, "pthread_mutex_lock", mutex); }
int pthread_mutex_trylock(pthread_mutex_t *mutex) { return lock(g_tryLock, "pthread_mutex_trylock", mutex); }
}
#endif

namespace {

class StepLocks : public testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        if (kAddressSanitizer || kThreadSanitizer) GTEST_SKIP() << "the sanitizer has its own functions in the place of the C library's";
    }

    // Five boxes at rest on the ground, or asleep.
    StepLocks() : m_world(dWorldCreate()), m_space(dHashSpaceCreate(nullptr)), m_contacts(dJointGroupCreate(0)) {
        dWorldSetGravity(m_world, 0, 0, -9.81);
        dCreatePlane(m_space, 0, 0, 1, 0);
        for (int i = 0; i < 5; ++i) {
            const dBodyID body = dBodyCreate(m_world);
            dBodySetPosition(body, 3 * i, 0, 0.5);
            dGeomSetBody(dCreateBox(m_space, 1, 1, 1), body);
        }
    }
    ~StepLocks() override {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }

    dWorldID world() const { return m_world; }

    // The fewest of some frames on one thread. The cost model tries two threads now and then, or prefers them for a while; then these take locks.
    unsigned locksOf(dWorldStepFunction *step) {
        constexpr int kEnough = 30, kMost = 20000;
        unsigned fewest = ~0u;
        for (int frame = 0, serial = 0; frame < kMost && serial < kEnough; ++frame) {
            dSpaceCollide(m_space, this, attach);
            const unsigned shared = dODE_MT_GetParallelSteps() + dODE_MT_GetTeamSteps();
            g_locks = 0;
            g_counting = true;
            step(m_world, 0.01);
            g_counting = false;
            dJointGroupEmpty(m_contacts);
            if (dODE_MT_GetParallelSteps() + dODE_MT_GetTeamSteps() != shared) continue;
            ++serial;
            fewest = std::min(fewest, g_locks.load());
        }
        return fewest;
    }

private:
    static void attach(void *own, dGeomID first, dGeomID second) {
        const StepLocks &test = *static_cast<StepLocks *>(own);
        dContact contacts[4] = {};
        const int count = dCollide(first, second, 4, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contacts[i].surface.mu = 1;
            dJointAttach(dJointCreateContact(test.m_world, test.m_contacts, &contacts[i]), dGeomGetBody(first), dGeomGetBody(second));
        }
    }

    const OdeSession m_session{GetParam() ? 2 : 0, "auto"};
    const dWorldID m_world;
    const dSpaceID m_space;
    const dJointGroupID m_contacts;
};

TEST_P(StepLocks, NoneAtRest) {
    EXPECT_EQ(locksOf(dWorldQuickStep), 0u);
    EXPECT_EQ(locksOf(dWorldStep), 0u);
}

TEST_P(StepLocks, NoneAsleep) {
    dWorldSetAutoDisableFlag(world(), 1);
    EXPECT_EQ(locksOf(dWorldQuickStep), 0u);
    EXPECT_EQ(locksOf(dWorldStep), 0u);
}

TEST_P(StepLocks, NoneToFindTheSettingsOfTheWorld) {
    dODE_MT_SetSolverTolerance(world(), 0.5);
    dODE_MT_SetWorldThreads(world(), 1);
    EXPECT_EQ(locksOf(dWorldQuickStep), 0u);
    EXPECT_EQ(locksOf(dWorldStep), 0u);
}

// Those of a fast dWorldQuickStep guard the solvers that its threads share.
TEST_P(StepLocks, OfFastSolvers) {
    dODE_MT_SetSolver(world(), "fast");
    EXPECT_LE(locksOf(dWorldQuickStep), 2u);
    EXPECT_EQ(locksOf(dWorldStep), 0u);
}

TEST_P(StepLocks, OneToCount) {
    dODE_MT_WorldStatistics statistics{};
    statistics.size = sizeof statistics;
    dODE_MT_GetWorldStatistics(world(), &statistics);
    EXPECT_EQ(locksOf(dWorldQuickStep), 1u);
    EXPECT_EQ(locksOf(dWorldStep), 1u);
}

INSTANTIATE_TEST_SUITE_P(Threads, StepLocks, testing::Bool(), [](const auto &info) { return info.param ? "two" : "none"; });

}  // namespace
