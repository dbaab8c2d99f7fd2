// Perturbed schedules (ODE_MT_PERTURB) reach every claim, hand-over, wait and commit: scenes that together come to each
// dxSchedulePoint. A point that none of them reaches fails the test by name.
#include "threading/dxSchedulePoints.h"

#include <gtest/gtest.h>
#include <ode/ode.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csetjmp>
#include <cstdio>
#include <limits>
#include <thread>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "sanitizers.h"
#include "PackedWorld.h"

namespace {

using namespace std::chrono_literals;

bool isReached(dxSchedulePoint point) { return dxTimesReached(point) > 0; }

std::vector<dxSchedulePoint> unreached() {
    std::vector<dxSchedulePoint> points;
    for (unsigned i = 0; i < kSchedulePoints; ++i)
        if (!isReached(static_cast<dxSchedulePoint>(i))) points.push_back(static_cast<dxSchedulePoint>(i));
    return points;
}

// --- scenes -----------------------------------------------------------------------------------------------

void stepIslands(const char *manager, int threads) {
    dODE_MT_SetThreadManager(manager);
    OdeSession::use(threads, "lcp");
    ChainWorld world(30, 4);
    world.step(5);
    std::this_thread::sleep_for(5ms);  // workers park
    world.step(5);
    dODE_MT_SetThreadManager("pthread");
}

void stepLargeIslands() {
    OdeSession::use(4, "lcp");
    PackedWorld quick(10, 8, 3, dWorldQuickStep), exact(3, 3, 1, dWorldStep);
    quick.frame();
    exact.frame();
    PackedWorld fast(16, 16, 3, dWorldQuickStep);
    dODE_MT_SetSolver(fast.world(), "fast");
    fast.frame();
    PackedWorld direct(16, 16, 2, dWorldStep);
    dODE_MT_SetSolver(direct.world(), "fast");
    direct.frame();
}

// In a heap nearly all pairs hang together; as independent ones they are several tasks.
void collideHeap() {
    OdeSession::use(3, "lcp");
    HeapWorld world(dHashSpaceCreate(nullptr));
    for (int i = 0; i < 20; ++i) {  // the first ones touch after ten
        world.collide();
        world.step();
    }
    dODE_MT_SetCallbackPolicy("independent");
    world.setCallback([](HeapWorld &, dGeomID o1, dGeomID o2) {
        dContactGeom contacts[4];
        dCollide(o1, o2, 4, contacts, sizeof contacts[0]);
    });
    for (int i = 0; i < 3; ++i) world.collide();
    dODE_MT_SetCallbackPolicy("serial");
}

std::jmp_buf g_place;

// A handler of the program's that hears of a fault leaves the step.
void interruptIslands() {
    OdeSession::use(3, "lcp");
    ChainWorld world(30, 4);
    for (const unsigned chain : {5u, 17u})
        dBodySetAngularVel(world.bodies()[chain * 4], std::numeric_limits<dReal>::quiet_NaN(), 0, 0);
    dSetDebugHandler([](int, const char *, va_list) { std::longjmp(g_place, 1); });
    if (setjmp(g_place) == 0) world.step();
    dSetDebugHandler(nullptr);
}

// In a process in which no thread has stepped before: of two threads the second one waits for the first one's step.
void stepOnTwoThreads() {
    OdeSession::use(0, "serial");
    ChainWorld longer(30, 6), shorter(2, 2);
    dWorldSetQuickStepNumIterations(longer.world(), 5000);
    std::atomic<bool> hasBegun{false};
    std::thread first([&] {
        hasBegun = true;
        longer.step();
    });
    while (!hasBegun) std::this_thread::yield();
    std::this_thread::sleep_for(10ms);
    shorter.step();
    first.join();
}

// Threads of the program ask a space that has just changed; its only user geom takes its time to say how large it is.
void askOnTwoThreads() {
    OdeSession::use(0, "serial");
    dGeomClass slow = {};
    slow.aabb = [](dGeomID, dReal box[6]) {
        std::this_thread::sleep_for(2ms);
        for (int i = 0; i < 6; ++i) box[i] = i % 2 == 0 ? -1 : 1;
    };
    slow.collider = [](int) -> dColliderFn * { return nullptr; };
    static const int number = dCreateGeomClass(&slow);
    const dSpaceID space = dHashSpaceCreate(nullptr);
    const dGeomID geom = dCreateGeom(number);
    dSpaceAdd(space, geom);
    for (int i = 0; i < 5; ++i) {
        dGeomSetPosition(geom, i, 0, 0);
        std::vector<std::thread> threads;
        for (int thread = 0; thread < 3; ++thread)
            threads.emplace_back([&] {
                const dGeomID ray = dCreateRay(nullptr, 5);
                dSpaceCollide2(ray, reinterpret_cast<dGeomID>(space), nullptr, [](void *, dGeomID, dGeomID) {});
                dGeomDestroy(ray);
            });
        for (std::thread &thread : threads) thread.join();
    }
    dSpaceDestroy(space);
}

void playScenes() {
    stepOnTwoThreads();
    askOnTwoThreads();
    stepIslands("pthread", 3);
    stepIslands("pthread", 1);
    stepIslands("openmp", 3);
    stepLargeIslands();
    collideHeap();
    interruptIslands();
}

}  // namespace

TEST(SchedulePoints, AreAllReached) {
    if (kThreadSanitizer) GTEST_SKIP() << "one of the points is reached by threads that ask a space which is to be cleaned: upstream's own race";
    const support::Ending end = support::runInChild([] {
        constexpr std::chrono::seconds kBudget{90};
        alarm(120);
        const OdeSession session;
        const auto begin = std::chrono::steady_clock::now();
        for (unsigned seed = 1; !unreached().empty() && std::chrono::steady_clock::now() - begin < kBudget; ++seed) {
            dxSetRandomPerturbation(seed);
            playScenes();
        }
        dxSetPerturbation(nullptr);
        for (const dxSchedulePoint point : unreached()) std::fprintf(stderr, "never: %s\n", dxDescribe(point));
    });
    EXPECT_TRUE(end.exitedWith(0));
    EXPECT_EQ(end.errors, "");
}

TEST(SchedulePoints, AreNotCountedWithoutAPerturbation) {
    const OdeSession session(3, "lcp");
    ChainWorld(10, 3).step(3);
    EXPECT_EQ(unreached().size(), kSchedulePoints);
}
