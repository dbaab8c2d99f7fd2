// The world nao_demo against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class NaoDemo : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("nao_demo"));

    Vector3 center(const std::string &part) const { return position(body(*scene, "robot::" + part)); }
};

TEST_F(NaoDemo, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u);
    EXPECT_EQ(scene->inventory().bodies.size(), 25u);
    EXPECT_EQ(scene->inventory().joints.size(), 24u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 5.305, 0.001);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.02);
}

TEST_F(NaoDemo, StandsAndWavesThreeTimes) {
    const dBodyID torso = body(*scene, "robot::torso");
    runFor(*scene, 2.2);
    EXPECT_GT(center("right_hand").z, center("head").z);
    EXPECT_LT(center("left_hand").z, center("torso").z);
    int waves = 0;
    double least = 10, most = -10;
    for (int i = 0; i < 120; ++i) {  // 2.4 s
        const auto angle = [&] {
            return dJointGetHingeAngle(joint(*scene, "robot::right_elbow_roll_joint"));
        };
        const double before = angle();
        scene->frame();
        waves += before < 0.9 && angle() >= 0.9;
        least = std::min(least, angle());
        most = std::max(most, angle());
        ASSERT_GT(dBodyGetRotation(torso)[10], 0.99) << scene->time();
    }
    EXPECT_EQ(waves, 3);
    EXPECT_LT(least, 0.6);
    EXPECT_GT(most, 1.2);
    runFor(*scene, 1.5);
    EXPECT_LT(center("right_hand").z, center("torso").z);
    EXPECT_LT(std::hypot(center("torso").x + 0.004, center("torso").y), 0.01);
}

}  // namespace
