// The recorder must see everything: two equal scenes are recorded, one of them with a single change, and
// the difference is named.
#include "recorder.h"
#include "comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include <unistd.h>

namespace {

using namespace exactness;

class Pendulum : public scenes::Scene {
public:
    Pendulum() : Scene(0.01), world(dWorldCreate()), space(dSimpleSpaceCreate(nullptr)) {
        body = dBodyCreate(world);
        other = dBodyCreate(world);
        ball = dCreateSphere(space, 1);
        plane = dCreatePlane(space, 0, 0, 1, 0);
        dGeomSetBody(ball, body);
        hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, body, other);
        dJointSetFeedback(hinge, &feedback);
        m_inventory = {{world}, {space}, {body, other}, {hinge}, {ball, plane}};
    }

    ~Pendulum() override {
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }

    void collide() override {}
    void step() override {}
    void finish() override {}

    dWorldID world;
    dSpaceID space;
    dBodyID body, other;
    dGeomID ball, plane;
    dJointID hinge;
    dJointFeedback feedback{};
};

using Change = std::function<void(Pendulum &, Recorder &)>;

Record recordAfter(const Change &change) {
    dRandSetSeed(1);
    Pendulum scene;
    Recorder recorder(scene, 0);
    change(scene, recorder);
    recorder.endStage("start");
    return recorder.take({});
}

Record unchanged() {
    return recordAfter([](Pendulum &, Recorder &) {});
}

// Expects that the change, and nothing before it, is seen in `object` and `field`.
void expectSeen(const Change &change, const std::string &object, const std::string &field) {
    const Record before = unchanged(), after = recordAfter(change);
    EXPECT_TRUE(firstDivergence(before, after)) << object << ", " << field;
    const auto difference = firstDifference(0, before, after);
    ASSERT_TRUE(difference) << object << ", " << field;
    EXPECT_EQ(difference->object, object);
    EXPECT_EQ(difference->field, field);
    EXPECT_NE(difference->expected, difference->actual);
}

class RecorderTest : public testing::Test {
protected:
    void SetUp() override { dInitODE2(0); }
    void TearDown() override { dCloseODE(); }
};

TEST_F(RecorderTest, EqualScenesGiveEqualRecords) { EXPECT_FALSE(firstDivergence(unchanged(), unchanged())); }

TEST_F(RecorderTest, BodiesAreSeen) {
    const double tiny = std::nextafter(0.0, 1.0);
    expectSeen([=](Pendulum &p, Recorder &) { dBodySetLinearVel(p.body, 0, tiny, 0); }, "body 0",
               "linear velocity[1]");
    expectSeen([=](Pendulum &p, Recorder &) { dBodySetAngularVel(p.other, 0, 0, -0.0); }, "body 1",
               "angular velocity[2]");
    expectSeen([=](Pendulum &p, Recorder &) { dBodyAddForce(p.body, tiny, 0, 0); }, "body 0", "force[0]");
    expectSeen([=](Pendulum &p, Recorder &) { dBodyAddTorque(p.body, 0, 0, tiny); }, "body 0", "torque[2]");
    expectSeen([](Pendulum &p, Recorder &) { dBodyDisable(p.other); }, "body 1", "enabled[0]");
    expectSeen([](Pendulum &p, Recorder &) { dBodySetAutoDisableSteps(p.body, 3); }, "body 0",
               "auto-disable steps[0]");
}

TEST_F(RecorderTest, JointsAreSeen) {
    expectSeen([](Pendulum &p, Recorder &) { dJointSetHingeParam(p.hinge, dParamFMax, 1); }, "joint 0",
               "hinge parameters[" + std::to_string(dParamFMax) + "]");
    expectSeen([](Pendulum &p, Recorder &) { p.feedback.t2[1] = 1; }, "joint 0", "feedback[10]");
    expectSeen([](Pendulum &p, Recorder &) { dJointDisable(p.hinge); }, "joint 0", "enabled[0]");
}

TEST_F(RecorderTest, OrderOfJointsOfABodyIsSeen) {
    expectSeen(
        [](Pendulum &p, Recorder &) { dJointAttach(dJointCreateBall(p.world, nullptr), p.body, nullptr); },
        "body 0", "joint list[0]");
}

TEST_F(RecorderTest, GeomsAndSpacesAreSeen) {
    expectSeen([](Pendulum &p, Recorder &) { dGeomDisable(p.plane); }, "geom 1", "enabled[0]");
    expectSeen([](Pendulum &p, Recorder &) { dGeomSphereSetRadius(p.ball, 2); }, "space 0",
               "bounding box[5]");
    expectSeen(
        [](Pendulum &p, Recorder &) {
            dSpaceRemove(p.space, p.ball);
            dSpaceAdd(p.space, p.ball);
        },
        "space 0", "order of geoms[0]");
}

TEST_F(RecorderTest, WorldAndRandomSeedAreSeen) {
    expectSeen([](Pendulum &p, Recorder &) { dWorldSetERP(p.world, 0.3); }, "world 0", "ERP[0]");
    expectSeen([](Pendulum &, Recorder &) { dRandInt(5); }, "process 0", "random seed[0]");
}

TEST_F(RecorderTest, EventsAreSeen) {
    const Record first = recordAfter([](Pendulum &p, Recorder &r) { r.nearPair(p.ball, p.plane); });
    const Record second = recordAfter([](Pendulum &p, Recorder &r) { r.nearPair(p.plane, p.ball); });
    const auto difference = firstDifference(0, first, second);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->object, "event 0");
    EXPECT_EQ(difference->field, "near pair[0]");
}

TEST_F(RecorderTest, UnsetFourthNumbersOfContactsAreSeen) {
    dContact contact{};
    const Record first = recordAfter([&](Pendulum &, Recorder &r) { r.contact(contact); });
    contact.geom.normal[3] = 1;
    const Record second = recordAfter([&](Pendulum &, Recorder &r) { r.contact(contact); });
    ASSERT_TRUE(firstDifference(0, first, second));
    EXPECT_EQ(firstDifference(0, first, second)->field, "contact[11]");
}

TEST_F(RecorderTest, PlaceOfAnAssertionInTheSourceIsCompared) {
    const auto note = [](const char *text) {
        return recordAfter([=](Pendulum &, Recorder &r) { r.note(text, 0); });
    };
    EXPECT_FALSE(firstDivergence(note("failed in f() [a.cpp:1]"), note("failed in f() [a.cpp:1]")));
    EXPECT_TRUE(firstDivergence(note("failed in f() [a.cpp:1]"), note("failed in f() [a.cpp:20]")));
}

TEST_F(RecorderTest, TextOnStandardErrorIsSeenIfItIsAFile) {
    const std::string path = testing::TempDir() + "/odemt_standard_error";
    std::FILE *file = std::fopen(path.c_str(), "a+");
    ASSERT_NE(file, nullptr);
    const int before = dup(fileno(stderr));
    dup2(fileno(file), fileno(stderr));
    const Record quiet = unchanged();
    const Record loud = recordAfter([](Pendulum &, Recorder &) { std::fputs("ODE Message 3\n", stderr); });
    dup2(before, fileno(stderr));
    std::fclose(file);
    EXPECT_TRUE(firstDivergence(quiet, loud));
}

}  // namespace
