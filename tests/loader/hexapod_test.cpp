// The world hexapod against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class Hexapod : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("hexapod"));
    dBodyID trunk = body(*scene, "hexapod::body");
};

TEST_F(Hexapod, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u);
    EXPECT_EQ(scene->inventory().bodies.size(), 13u);
    EXPECT_EQ(scene->inventory().joints.size(), 12u);
    EXPECT_NEAR(totalMass(*scene, "hexapod"), 2.965, 1e-3);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.008);
    EXPECT_DOUBLE_EQ(dWorldGetERP(scene->inventory().worlds[0]), 0.6);
}

TEST_F(Hexapod, WalksForwardOnThreeLegsAtATime) {
    runFor(*scene, 2.4);
    const Vector3 start = position(trunk);
    for (int i = 0; i < 900; ++i) {  // 7.2 s, three strides
        scene->frame();
        ASSERT_GT(position(trunk).z, 0.07);
        ASSERT_GT(dBodyGetRotation(trunk)[10], 0.97);
    }
    EXPECT_NEAR((position(trunk) - start).x, 0.72, 0.1);  // 0.24 m a stride
}

TEST_F(Hexapod, SweepsItsJointsFromStopToStop) {
    double hip[2] = {10, -10}, knee[2] = {10, -10};
    for (int i = 0; i < 600; ++i) {
        scene->frame();
        const double angle = dJointGetHingeAngle(joint(*scene, "hexapod::right_front_hip"));
        const double length = dJointGetSliderPosition(joint(*scene, "hexapod::right_front_knee"));
        hip[0] = std::min(hip[0], angle);
        hip[1] = std::max(hip[1], angle);
        knee[0] = std::min(knee[0], length);
        knee[1] = std::max(knee[1], length);
    }
    EXPECT_NEAR(hip[0], -0.7, 0.01);
    EXPECT_NEAR(hip[1], 0.7, 0.01);
    EXPECT_NEAR(knee[0], -0.02, 1e-3);
    EXPECT_NEAR(knee[1], 0.02, 1e-3);
}

}  // namespace
