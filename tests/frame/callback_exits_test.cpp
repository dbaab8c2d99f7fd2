// Callbacks that never return: they leave by longjmp or an exception, or end their thread. What comes after is as fast, and
// as exact, as before.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <pthread.h>

#include <atomic>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ChainWorld.h"
#include "support/child_run.h"
#include "Deadline.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "SphereRows.h"
#include "processThreads.h"
#include "sanitizers.h"

namespace {

std::jmp_buf g_place;

dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 3);
}

struct Way {
    const char *name;
    void (*leave)();
};

void PrintTo(const Way &way, std::ostream *out) { *out << way.name; }

const Way kWays[] = {{"Longjmp", [] { std::longjmp(g_place, 1); }},
                     {"Exception", [] { throw std::runtime_error("enough"); }}};

// Calls `frame`, which is left in the middle.
template <class Frame>
void leaveIn(const Frame &frame) {
    if (setjmp(g_place) != 0) return;
    try {
        frame();
    } catch (const std::runtime_error &) {
    }
}

class LeftCallback : public testing::TestWithParam<std::tuple<dSpaceID (*)(dSpaceID), Way>> {
protected:
    static dSpaceID createSpace() { return std::get<0>(GetParam())(nullptr); }
    static void leave() { std::get<1>(GetParam()).leave(); }
};

// Until the bodies, which fall at first, touch.
void settle(HeapWorld &world) {
    for (int i = 0; i < 30; ++i) {
        world.collide();
        world.step();
    }
}

unsigned sharedBy(HeapWorld &world) {
    const unsigned before = dODE_MT_GetContactsAhead();
    world.setCallback([](HeapWorld &, dGeomID o1, dGeomID o2) {
        dContactGeom contacts[4];
        dCollide(o1, o2, 4, contacts, sizeof contacts[0]);
    });
    // What was computed for the call that was left was not asked for, so that the next ones go without.
    constexpr int kMaxPauses = 200;
    for (int i = 0; i < kMaxPauses && dODE_MT_GetContactsAhead() == before; ++i) world.collide();
    return dODE_MT_GetContactsAhead() - before;
}

// In a child, because the space stays locked, as upstream's, and cannot be destroyed.
TEST_P(LeftCallback, NextCollisionsAreSharedAgain) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        auto &left = *new HeapWorld(createSpace());
        HeapWorld other(createSpace());
        settle(left);
        settle(other);
        const bool sharedBefore = sharedBy(left) > 0 && sharedBy(other) > 0;
        for (int i = 0; i < 3; ++i) {
            left.setCallback([](HeapWorld &, dGeomID, dGeomID) { leave(); });
            leaveIn([&left] { left.collide(); });
        }
        const bool other2 = sharedBy(other) > 0, left2 = sharedBy(left) > 0;
        if (!sharedBefore || !other2 || !left2)
            std::fprintf(stderr, "shared: before %d, another space %d, the same space %d\n", sharedBefore, other2, left2);
        _exit(sharedBefore && other2 && left2 ? 0 : 1);
        return true;
    }));
}

// The call that was left says nothing about the geoms any more.
TEST_P(LeftCallback, DCollideComputesAnew) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        auto &world = *new HeapWorld(createSpace());
        settle(world);
        static dGeomID one, two;
        world.setCallback([](HeapWorld &, dGeomID o1, dGeomID o2) {
            one = o1, two = o2;
            leave();
        });
        leaveIn([&world] { world.collide(); });
        dContactGeom contacts[4];
        for (int i = 0; i < 4; ++i) dCollide(one, two, 4, contacts, sizeof contacts[0]);
        dBodyCreate(dBodyGetWorld(dGeomGetBody(one) != nullptr ? dGeomGetBody(one) : dGeomGetBody(two)));
        _exit(0);
        return true;
    }));
}

// Deeper on the stack than the call that was left. Returns the number of contacts.
[[gnu::noinline]] int collideDeeper(dGeomID o1, dGeomID o2) {
    volatile char room[1 << 16];
    room[0] = room[sizeof room - 1] = 0;
    dContactGeom contacts[4];
    return dCollide(o1, o2, 4, contacts, sizeof contacts[0]) + room[0];
}

void useFreedMemory() {
    for (std::size_t size = 16; size < 4096; size += 16)
        for (int i = 0; i < 8; ++i) std::memset(std::malloc(size), 0xa5, size);
}

// The space stays locked, and its destructor reports that half way; it is not accessed any more.
TEST_P(LeftCallback, TheSpaceMayBeDestroyed) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        const dGeomID ball = dCreateSphere(nullptr, 1), box = dCreateBox(nullptr, 1, 1, 1);
        const dSpaceID space = createSpace();
        auto &world = *new HeapWorld(space);
        settle(world);
        const bool isShared = sharedBy(world) > 0;
        world.setCallback([](HeapWorld &, dGeomID, dGeomID) { leave(); });
        leaveIn([&world] { world.collide(); });
        dSetDebugHandler([](int, const char *, va_list) { std::longjmp(g_place, 1); });
        leaveIn([space] { dSpaceDestroy(space); });
        useFreedMemory();
        _exit(isShared && collideDeeper(ball, box) == 1 ? 0 : 1);
        return true;
    }));
}

// Of the user's class; it leaves once.
bool g_isBoxFunctionLeaving = false;
void (*g_leaveBoxFunction)() = nullptr;

void boundAndLeave(dGeomID geom, dReal box[6]) {
    const dReal *const place = dGeomGetPosition(geom);
    for (int i = 0; i < 6; ++i) box[i] = place[i / 2] + (i % 2 == 0 ? -1 : 1);
    if (std::exchange(g_isBoxFunctionLeaving, false)) g_leaveBoxFunction();
}

dColliderFn *noCollider(int) { return nullptr; }

// Where the frame of the call was that has been left.
[[gnu::noinline]] void useStack() {
    volatile char room[1 << 16];
    for (std::size_t i = 0; i < sizeof room; ++i) room[i] = char(0xa5);
}

// Cleaning goes on without the workers of the call that was left, and a sweep-and-prune space fails upstream's assertion at the next one.
TEST_P(LeftCallback, ABoxFunctionMayLeave) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        const dGeomClass description = {sizeof(int), &noCollider, &boundAndLeave, nullptr, nullptr};
        const int usersClass = dCreateGeomClass(&description);
        const dSpaceID space = createSpace();
        std::vector<dGeomID> geoms;
        for (int i = 0; i < 600; ++i) {
            geoms.push_back(i == 300 ? dCreateGeom(usersClass) : dCreateBox(nullptr, 1, 1, 1));
            dSpaceAdd(space, geoms.back());
        }
        const auto collide = [space] { dSpaceCollide(space, nullptr, [](void *, dGeomID, dGeomID) {}); };
        for (int frame = 0; frame < 10; ++frame) {
            for (int i = 0; i < 600; ++i) dGeomSetPosition(geoms[i], (37 * i + frame) % 60, (53 * i + 7 * frame) % 60, 0);
            g_isBoxFunctionLeaving = frame == 9;
            g_leaveBoxFunction = &leave;
            leaveIn(collide);
        }
        useStack();
        static std::string text;
        dSetDebugHandler([](int, const char *format, va_list) {
            text = format;
            std::longjmp(g_place, 1);
        });
        const bool isSweep = dGeomGetClass(reinterpret_cast<dGeomID>(space)) == dSweepAndPruneSpaceClass;
        const dGeomID ball = dCreateSphere(nullptr, 20);
        if (!isSweep) leaveIn([=] { dSpaceCollide2(ball, reinterpret_cast<dGeomID>(space), nullptr, [](void *, dGeomID, dGeomID) {}); });
        leaveIn(collide);
        _exit(g_isBoxFunctionLeaving || (isSweep && text != "geom counts messed up in %s()") ? 1 : 0);
        return true;
    }));
}

constexpr const char *kSpaceNames[] = {"simple", "hash", "quadtree", "sweep"};

INSTANTIATE_TEST_SUITE_P(Spaces, LeftCallback,
                         testing::Combine(testing::Values(dSimpleSpaceCreate, dHashSpaceCreate, createQuadTree,
                                                          createSweepSpace),
                                          testing::ValuesIn(kWays)),
                         [](const auto &info) {
                             return std::string(kSpaceNames[info.index / std::size(kWays)]) +
                                    std::get<1>(info.param).name;
                         });

// A step that a moved-callback leaves: another thread's first step does not wait for it without limit.
TEST(LeftStep, AnotherThreadSteps) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(2, "lcp");
        auto &world = *new ChainWorld(10, 3);
        dBodySetMovedCallback(world.bodies()[5], [](dBodyID) { std::longjmp(g_place, 1); });
        for (int i = 0; i < 3; ++i) leaveIn([&world] { world.step(); });
        std::thread([] { ChainWorld(10, 3).step(3); }).join();
        dBodySetMovedCallback(world.bodies()[5], nullptr);
        _exit(0);
        return true;
    }));
}

// --- pthread_exit ------------------------------------------------------------------------------------------

struct Scene {
    SphereRows rows{dHashSpaceCreate(nullptr)};
    dJointGroupID group = dJointGroupCreate(0);
    pthread_t caller{};
    bool onWorker = false;
    std::atomic<bool> callerCame{false}, workerCame{false};
};

void joinAndEndThread(void *data, dGeomID o1, dGeomID o2) {
    Scene &scene = *static_cast<Scene *>(data);
    const bool isWorker = !pthread_equal(pthread_self(), scene.caller);
    dContact contact{};
    contact.surface.mode = 0;
    if (dCollide(o1, o2, 1, &contact.geom, sizeof contact) > 0)
        dJointAttach(dJointCreateContact(scene.rows.world(), scene.group, &contact), dGeomGetBody(o1), dGeomGetBody(o2));
    (isWorker ? scene.workerCame : scene.callerCame) = true;
    comesTrue([&scene] { return scene.workerCame && scene.callerCame; });
    if (isWorker == scene.onWorker) pthread_exit(nullptr);
}

class EndedThread : public testing::TestWithParam<bool> {};

TEST_P(EndedThread, EndsTheCallersThreadAndNothingElse) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        dODE_MT_SetCallbackPolicy("concurrent");
        for (int i = 0; i < 3; ++i) {
            Scene &scene = *new Scene;  // its space stays locked
            scene.onWorker = GetParam();
            bool returned = false;
            std::thread([&scene, &returned] {
                scene.caller = pthread_self();
                dSpaceCollide(scene.rows.space(), &scene, joinAndEndThread);
                returned = true;
            }).join();
            if (returned) return false;
            dJointGroupEmpty(scene.group);  // the joints made so far are in their lists
            dJointGroupDestroy(scene.group);
        }
        // The pool is whole: three callbacks at one time.
        const SphereRows rows(dHashSpaceCreate(nullptr));
        std::atomic<int> inside{0};
        dSpaceCollide(rows.space(), &inside, [](void *counter, dGeomID, dGeomID) {
            std::atomic<int> &came = *static_cast<std::atomic<int> *>(counter);
            static thread_local bool isCounted = false;
            if (!isCounted) ++came;
            isCounted = true;
            comesTrue([&came] { return came >= 3; });
        });
        dODE_MT_SetCallbackPolicy("serial");
        return inside >= 3;
    }));
}

INSTANTIATE_TEST_SUITE_P(Threads, EndedThread, testing::Bool(),
                         [](const auto &info) { return info.param ? "worker" : "caller"; });

}  // namespace
