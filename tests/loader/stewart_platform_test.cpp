// The world stewart_platform against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <cmath>

namespace {

using namespace small_world;

class StewartPlatform : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("stewart_platform"));
    dBodyID disc = body(*scene, "platform::disc");

    double yaw() const { return std::atan2(dBodyGetRotation(disc)[4], dBodyGetRotation(disc)[0]); }
    double upright() const { return dBodyGetRotation(disc)[10]; }
};

TEST_F(StewartPlatform, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u + 48u);
    EXPECT_EQ(scene->inventory().bodies.size(), 14u + 5u);
    EXPECT_EQ(scene->inventory().joints.size(), 18u);
    // Base, platform, six pistons.
    EXPECT_NEAR(totalMass(*scene, "platform"), 415.4756 + 5.3093 + 6 * (0.502655 + 0.278345), 1e-3);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.004);
    EXPECT_NEAR(position(disc).z, 2.75, 1e-6);
}

// The six loops stay closed: the ends of each rod and the platform do not come apart.
TEST_F(StewartPlatform, TwistsToBothSides) {
    runFor(*scene, 0.9);
    EXPECT_NEAR(yaw(), 1.05, 0.03);
    EXPECT_NEAR(position(disc).z, 2.43, 0.01);
    runFor(*scene, 1);
    EXPECT_NEAR(yaw(), -1.05, 0.03);
    EXPECT_NEAR(dJointGetSliderPosition(joint(*scene, "platform::piston_1")), 0.4, 0.01);
    EXPECT_NEAR(dJointGetSliderPosition(joint(*scene, "platform::piston_2")), -0.4, 0.01);
    for (int i = 1; i <= 6; ++i) {
        const dJointID ball = joint(*scene, "platform::piston_" + std::to_string(i) + "_ball");
        dVector3 rod, platform;
        dJointGetBallAnchor(ball, rod);
        dJointGetBallAnchor2(ball, platform);
        EXPECT_LT(std::hypot(rod[0] - platform[0], rod[1] - platform[1], rod[2] - platform[2]), 1e-3);
    }
}

TEST_F(StewartPlatform, TiltsMoreAndMoreUntilABoxFalls) {
    runFor(*scene, 4);
    EXPECT_GT(upright(), 0.995);
    EXPECT_GT(position(body(*scene, "box_5::box")).z, 3);
    runFor(*scene, 6);
    EXPECT_LT(upright(), 0.985);
    EXPECT_LT(position(body(*scene, "box_5::box")).z, 1);
    EXPECT_GT(position(body(*scene, "box_1::box")).z, 2.5);
}

}  // namespace
