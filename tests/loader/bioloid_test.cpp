// The world bioloid against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <cmath>

namespace {

using namespace small_world;

class Bioloid : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("bioloid"));

    Vector3 center(const std::string &part) const { return position(body(*scene, "robot::" + part)); }
    double height() const { return center("base").z; }
};

TEST_F(Bioloid, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u);
    EXPECT_EQ(scene->inventory().bodies.size(), 17u + 17u);
    EXPECT_EQ(scene->inventory().joints.size(), 16u);
    EXPECT_EQ(scene->inventory().geoms.size(), 1u + 17u + 33u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 1.76, 1e-12);
    for (int i = 1; i <= 17; ++i) EXPECT_DOUBLE_EQ(totalMass(*scene, "ball_" + std::to_string(i)), 0.1);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.016);

    const dWorldID world = scene->inventory().worlds[0];
    EXPECT_DOUBLE_EQ(dWorldGetCFM(world), 1e-4);
    EXPECT_DOUBLE_EQ(dWorldGetERP(world), 0.6);
    EXPECT_NEAR(dWorldGetLinearDamping(world), 1 - std::pow(0.8, 0.016), 1e-8);
    EXPECT_NEAR(dWorldGetAngularDamping(world), 1 - std::pow(0.8, 0.016), 1e-8);
    EXPECT_DOUBLE_EQ(dWorldGetAutoDisableTime(world), 1);
}

struct Hinge {
    const char *name;
    Vector3 anchor, axis;  // at the start, in the world
};

TEST_F(Bioloid, HasItsHingesWhereTheFileHasThem) {
    const Hinge hinges[] = {
        {"front_left_1", {0.0565, 0.086, 0.1135}, {0, 1, 0}},
        {"front_left_2", {0.0565, 0.092, 0.099}, {-1, 0, 0}},
        {"front_left_3", {0.0565, 0.175, 0.099}, {0, 0, 1}},
        {"front_right_1", {0.0565, -0.086, 0.1135}, {0, 1, 0}},
        {"front_right_2", {0.0565, -0.092, 0.099}, {-1, 0, 0}},
        {"front_right_3", {0.0565, -0.175, 0.099}, {0, 0, -1}},
        {"pelvis", {-0.0875, 0, 0.0865}, {-1, 0, 0}},
        {"back_left_1", {-0.1085, 0.062, 0.1}, {0, 1, 0}},
        {"back_left_2", {-0.1085, 0.068, 0.0855}, {-1, 0, 0}},
        {"back_left_3", {-0.1085, 0.151, 0.0855}, {0, 0, 1}},
        {"back_right_1", {-0.1085, -0.062, 0.1}, {0, 1, 0}},
        {"back_right_2", {-0.1085, -0.068, 0.0855}, {-1, 0, 0}},
        {"back_right_3", {-0.1085, -0.151, 0.0855}, {0, 0, -1}},
        {"neck_1", {0.079, 0, 0.1}, {0, 1, 0}},
        {"neck_2", {0.126, 0, 0.1}, {-1, 0, 0}},
        {"head", {0.1935, 0, 0.108}, {0, 1, 0}},
    };
    for (const Hinge &hinge : hinges) {
        const dJointID found = joint(*scene, std::string("robot::") + hinge.name + "_joint");
        dVector3 anchor, axis;
        dJointGetHingeAnchor(found, anchor);
        dJointGetHingeAxis(found, axis);
        // The file rounds the place of the front left leg by 0.015 mm.
        EXPECT_LT((Vector3{anchor[0], anchor[1], anchor[2]} - hinge.anchor).length(), 2e-5) << hinge.name;
        EXPECT_LT((Vector3{axis[0], axis[1], axis[2]} - hinge.axis).length(), 1e-9) << hinge.name;
    }
}

TEST_F(Bioloid, HasItsCentresOfMassWhereTheFileHasThem) {
    EXPECT_LT((center("base") - Vector3{0, 0, 0.102}).length(), 1e-9);
    EXPECT_LT((center("pelvis") - Vector3{-0.1085, 0, 0.091}).length(), 1e-9);
    // Half a turn about x: y and z are negated.
    EXPECT_LT((center("front_right_2") - Vector3{0.0585, -0.1335, 0.097}).length(), 1e-9);
    EXPECT_LT((center("head") - Vector3{0.1935, 0, 0.0685}).length(), 1e-9);
}

TEST_F(Bioloid, StandsUp) {
    EXPECT_NEAR(height(), 0.102, 1e-9);
    runFor(*scene, 0.08);
    EXPECT_LT(height(), 0.08);  // it drops on its belly, whose underside is 16 mm below the torso's middle
    runFor(*scene, 0.92);
    EXPECT_GT(height(), 0.15);  // straight legs hold the torso 0.17 to 0.19 m high
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "robot::front_left_2_joint")), 1.5708, 0.1);
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "robot::neck_1_joint")), -1.5708, 0.2);
}

TEST_F(Bioloid, WalksForwardUpright) {
    runFor(*scene, 2);
    const Vector3 start = center("base");
    for (int i = 0; i < 500; ++i) {
        scene->frame();
        ASSERT_TRUE(isFinite(*scene));
        ASSERT_GT(height(), 0.1);
        ASSERT_LT(height(), 0.25);
        ASSERT_GT(dBodyGetRotation(body(*scene, "robot::base"))[10], 0.9);  // z of its z axis
    }
    EXPECT_GT((center("base") - start).x, 0.5);
}

// The motors cannot follow their targets; an ideal motor without load would swing as far as they ask.
TEST_F(Bioloid, SwingsItsLegsAsFarAsTheMotorsCan) {
    runFor(*scene, 4);
    double least = 10, most = -10;
    for (int i = 0; i < 250; ++i) {
        scene->frame();
        const double angle = dJointGetHingeAngle(joint(*scene, "robot::back_left_1_joint"));
        least = std::min(least, angle);
        most = std::max(most, angle);
    }
    EXPECT_NEAR(least, -0.85, 0.1);
    EXPECT_NEAR(most, -0.35, 0.1);
}

}  // namespace
