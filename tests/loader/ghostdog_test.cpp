// The world ghostdog against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class GhostDog : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("ghostdog"));
    dBodyID trunk = body(*scene, "dog::body");

    double angle(const std::string &name) const { return dJointGetHingeAngle(joint(*scene, "dog::" + name)); }
};

TEST_F(GhostDog, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u);
    EXPECT_EQ(scene->inventory().bodies.size(), 21u);
    EXPECT_EQ(scene->inventory().joints.size(), 20u);
    // Body, pelvis, neck and head; legs.
    EXPECT_NEAR(totalMass(*scene, "dog"), 4.2 + 4 + 0.075 + 0.06 + 1.28 + 4 * (0.201062 + 0.01 + 0.2 + 0.01),
                1e-9);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.004);
    EXPECT_DOUBLE_EQ(dWorldGetCFM(scene->inventory().worlds[0]), 1e-4);
}

TEST_F(GhostDog, RunsForwardUpright) {
    runFor(*scene, 3);
    const double start = position(trunk).x;
    for (int i = 0; i < 1250; ++i) {  // 5 s
        scene->frame();
        ASSERT_GT(dBodyGetRotation(trunk)[10], 0.7) << scene->time();
        ASSERT_GT(position(trunk).z, 0.15) << scene->time();
    }
    EXPECT_GT(position(trunk).x - start, 6);  // m; 1.7 m/s
    EXPECT_NEAR(position(trunk).y, 0, 0.01);
}

// A shank turns against the knee that its motor holds, and is pushed back.
TEST_F(GhostDog, YieldsOnItsSprings) {
    double most = 0, knee = 0;
    for (int i = 0; i < 1000; ++i) {
        scene->frame();
        most = std::max(most, std::abs(angle("front_left_spring")));
        knee = std::max(knee, std::abs(angle("front_left_knee_joint")));
    }
    EXPECT_GT(most, 0.1);
    EXPECT_LT(most, 1);
    EXPECT_LT(knee, 0.05);
}

}  // namespace
