// The calls of programs written for the multithreaded ODE of Webots.
//
// Covers api/ode_MT_webots.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <csetjmp>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "OdeSession.h"

namespace {

// What was called, in order; the functions below have no context of their own.
std::vector<std::string> g_calls;
dSpaceID g_expectedSpace;

void near(void *data, dGeomID, dGeomID) { g_calls.push_back("near " + *static_cast<std::string *>(data)); }

int stepper(dWorldID world, dReal stepSize) {
    g_calls.push_back("step " + std::to_string(stepSize).substr(0, 4));
    return dWorldStep(world, stepSize);
}

void update(int threadID) {
    g_calls.push_back("update " + std::to_string(threadID));
    EXPECT_EQ(dThreadGetSpacesCount(-1), 1);
    EXPECT_EQ(dThreadGetSpaceID(-1, 0), g_expectedSpace);
    EXPECT_EQ(dThreadGetSpaceID(-1, 1), nullptr);
    EXPECT_EQ(dThreadGetSpaceID(-1, -1), nullptr);
    EXPECT_EQ(dThreadGetSpacesCount(0), 0);
    EXPECT_EQ(dThreadGetSpaceID(0, 0), nullptr);
    std::thread([] { EXPECT_EQ(dThreadGetSpacesCount(-1), 0) << "another thread is in no frame"; }).join();
}

class Webots : public testing::Test {
protected:
    Webots() : world(dWorldCreate()), space(dSimpleSpaceCreate(nullptr)) {
        testing::FLAGS_gtest_death_test_style = "threadsafe";
        g_calls.clear();
        g_expectedSpace = space;
        body = dBodyCreate(world);
        for (dGeomID &ball : balls) {
            ball = dCreateSphere(space, 1);
            dGeomSetPosition(ball, &ball == balls ? 0 : 0.5, 0, 0);
        }
        dGeomSetBody(balls[0], body);
        dBodySetLinearVel(body, 1, 0, 0);
    }
    ~Webots() override {
        dBodyDestroy(body);
        for (const dGeomID ball : balls) dGeomDestroy(ball);
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }

    OdeSession session;
    const dWorldID world;
    const dSpaceID space;
    dBodyID body = nullptr;
    dGeomID balls[2];
    std::string data = "data";
};

using Calls = std::vector<std::string>;

TEST_F(Webots, CollideAndStep) {
    dSpaceCollideAndWorldStep(space, &data, near, world, 0.25, stepper);
    EXPECT_EQ(g_calls, (Calls{"near data", "step 0.25"}));
    EXPECT_EQ(dBodyGetPosition(body)[0], 0.25);
}

TEST_F(Webots, StepAndCollide) {
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, update);
    EXPECT_EQ(g_calls, (Calls{"step 0.25", "update -1", "near data"}));
}

TEST_F(Webots, StepAndCollideWithoutUpdate) {
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, nullptr);
    EXPECT_EQ(g_calls, (Calls{"step 0.25", "near data"}));
}

TEST_F(Webots, StepComesBeforeCollide) {
    dBodySetPosition(body, -2, 0, 0);
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, nullptr);
    EXPECT_EQ(g_calls, Calls{"step 0.25"}) << "still apart";
    g_calls.clear();
    dBodySetLinearVel(body, 4, 0, 0);
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, nullptr);
    EXPECT_EQ(g_calls, (Calls{"step 0.25", "near data"})) << "the step has brought them together";
}

TEST_F(Webots, NoSpacesOutsideAFrame) {
    const auto expectNone = [] {
        for (const int thread : {-2, -1, 0, 5}) {
            EXPECT_EQ(dThreadGetSpacesCount(thread), 0);
            EXPECT_EQ(dThreadGetSpaceID(thread, 0), nullptr);
        }
    };
    expectNone();
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, update);
    expectNone();
}

TEST_F(Webots, FrameWithinAFrame) {
    static dSpaceID innerSpace;
    static dWorldID innerWorld;
    innerSpace = dSimpleSpaceCreate(nullptr);
    innerWorld = dWorldCreate();
    const auto outerUpdate = [](int) {
        const auto innerUpdate = [](int) { EXPECT_EQ(dThreadGetSpaceID(-1, 0), innerSpace); };
        dWorldStepAndSpaceCollide(innerSpace, nullptr, near, innerWorld, 0.1, dWorldStep, innerUpdate);
        update(-1);
    };
    dWorldStepAndSpaceCollide(space, &data, near, world, 0.25, stepper, outerUpdate);
    dSpaceDestroy(innerSpace);
    dWorldDestroy(innerWorld);
}

TEST_F(Webots, NoFrameIsLeftBehindByAnException) {
    const auto throwing = [](int) { throw 1; };
    EXPECT_THROW(dWorldStepAndSpaceCollide(space, &data, near, world, 0.1, stepper, throwing), int);
    EXPECT_EQ(dThreadGetSpacesCount(-1), 0);
}

TEST_F(Webots, NoFrameIsLeftBehindByAJump) {
    static std::jmp_buf place;
    const auto jumping = [](int) { std::longjmp(place, 1); };
    if (setjmp(place) == 0) dWorldStepAndSpaceCollide(space, &data, near, world, 0.1, stepper, jumping);
    const int count = dThreadGetSpacesCount(-1);
    const dSpaceID left = dThreadGetSpaceID(-1, 0);
    EXPECT_EQ(count, 0);
    EXPECT_EQ(left, nullptr);
}

TEST_F(Webots, GeomsAreTheSameOnlyAsThemselves) {
    EXPECT_EQ(dAreGeomsSame(balls[0], balls[0]), 1);
    EXPECT_EQ(dAreGeomsSame(balls[0], balls[1]), 0);
    EXPECT_EQ(dAreGeomsSame(balls[0], nullptr), 0);
}

TEST_F(Webots, OneClusterWithoutAGrid) {
    EXPECT_EQ(dClusterGetCount(world, space), 1);
    EXPECT_EQ(dClusterGetGridStep(world, space), 0);
    float x = 1, y = 2, z = 3;
    dClusterGetCenter(world, space, &x, &y, &z);
    EXPECT_EQ(x, 0);
    EXPECT_EQ(y, 0);
    EXPECT_EQ(z, 0);
    x = 1;
    dClusterGetCenter(world, space, x, y, z);
    EXPECT_EQ(x, 0);
}

TEST_F(Webots, CallsWithoutEffect) {
    dGeomSetDynamicFlag(balls[0]);
    dWorldRefreshParameters(world);
    EXPECT_EQ(dSpaceGetNumGeoms(space), 2);
}

TEST_F(Webots, NullArgumentsAreNamed) {
    const auto aborted = testing::KilledBySignal(SIGABRT);
    EXPECT_EXIT(dSpaceCollideAndWorldStep(nullptr, &data, near, world, 0.1, stepper), aborted,
                "bad space argument in dSpaceCollideAndWorldStep");
    EXPECT_EXIT(dSpaceCollideAndWorldStep(space, &data, nullptr, world, 0.1, stepper), aborted,
                "bad callback argument in dSpaceCollideAndWorldStep");
    EXPECT_EXIT(dSpaceCollideAndWorldStep(space, &data, near, nullptr, 0.1, stepper), aborted,
                "bad world argument in dSpaceCollideAndWorldStep");
    EXPECT_EXIT(dSpaceCollideAndWorldStep(space, &data, near, world, 0.1, nullptr), aborted,
                "bad stepper argument in dSpaceCollideAndWorldStep");
    EXPECT_EXIT(dWorldStepAndSpaceCollide(nullptr, &data, near, world, 0.1, stepper, update), aborted,
                "bad space argument in dWorldStepAndSpaceCollide");
    EXPECT_EXIT(dWorldStepAndSpaceCollide(space, &data, near, world, 0.1, nullptr, update), aborted,
                "bad stepper argument in dWorldStepAndSpaceCollide");
    EXPECT_EXIT(dGeomSetDynamicFlag(nullptr), aborted, "bad geom argument in dGeomSetDynamicFlag");
    EXPECT_EXIT(dWorldRefreshParameters(nullptr), aborted, "bad world argument in dWorldRefreshParameters");
    float x = 0;
    EXPECT_EXIT(dClusterGetCenter(world, space, &x, nullptr, &x), aborted,
                "bad y argument in dClusterGetCenter");
}

// A space is not stepped through: what is said of a null world holds for the step size as well.
TEST_F(Webots, StepSizeIsTheSteppersToCheck) {
    EXPECT_EXIT(dSpaceCollideAndWorldStep(space, &data, near, world, 0, dWorldStep),
                testing::KilledBySignal(SIGABRT), "stepsize must be > 0 in dWorldStep");
}

}  // namespace
