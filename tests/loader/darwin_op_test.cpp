// The world darwin_op against its facts.
#include "touched_models.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class DarwinOp : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("darwin_op"));
};

TEST_F(DarwinOp, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u + 5u);
    EXPECT_EQ(scene->inventory().bodies.size(), 21u + 1u);
    EXPECT_EQ(scene->inventory().joints.size(), 20u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 3.107, 0.001);
    EXPECT_DOUBLE_EQ(totalMass(*scene, "ball"), 0.055);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.016);
}

TEST_F(DarwinOp, StandsOnTheTableAndLooksAround) {
    const dBodyID trunk = body(*scene, "robot::body");
    TouchedModels watch(*scene);
    scene->observe(&watch);
    double pan[2] = {10, -10}, tilt[2] = {10, -10};
    for (int i = 0; i < 500; ++i) {  // 8 s
        scene->frame();
        const double side = dJointGetHingeAngle(joint(*scene, "robot::head_pan_joint"));
        const double up = dJointGetHingeAngle(joint(*scene, "robot::head_tilt_joint"));
        pan[0] = std::min(pan[0], side);
        pan[1] = std::max(pan[1], side);
        tilt[0] = std::min(tilt[0], up);
        tilt[1] = std::max(tilt[1], up);
        ASSERT_GT(dBodyGetRotation(trunk)[10], 0.99) << scene->time();
    }
    EXPECT_NEAR(pan[0], -0.79, 0.02);
    EXPECT_NEAR(pan[1], 0.79, 0.02);
    EXPECT_NEAR(tilt[0], -0.29, 0.02);
    EXPECT_NEAR(tilt[1], 0.29, 0.02);
    EXPECT_NEAR(position(trunk).z, 1.046, 0.002);
    EXPECT_EQ(watch.pairs,
              (std::set<std::pair<std::string, std::string>>{{"ball", "table"}, {"robot", "table"}}));
}

}  // namespace
