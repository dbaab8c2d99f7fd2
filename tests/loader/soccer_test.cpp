// The world soccer against its facts.
#include "box_sums.h"

#include "loader/load_world.h"

#include <cmath>
#include <set>

namespace {

using namespace small_world;

class Soccer : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("soccer"));

    Vector3 player(const std::string &name) const { return position(body(*scene, name + "::body")); }
    double wheelSpeed(const std::string &player, const std::string &wheel) const {
        return dJointGetHingeParam(joint(*scene, player + "::" + wheel + "_wheel_joint"), dParamVel);
    }
};

const char *const players[] = {"blue_1", "blue_2", "blue_3", "yellow_1", "yellow_2", "yellow_3"};

TEST_F(Soccer, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 17u);
    EXPECT_EQ(scene->inventory().bodies.size(), 19u);
    EXPECT_EQ(scene->inventory().joints.size(), 12u);
    EXPECT_EQ(scene->inventory().geoms.size(), 36u);
    for (const char *name : players) EXPECT_NEAR(totalMass(*scene, name), 0.21, 1e-12);
    EXPECT_NEAR(totalMass(*scene, "ball"), 0.05, 1e-12);
}

TEST_F(Soccer, PutsEverythingWhereTheFileHasIt) {
    const BoxSums sums = sumOfStaticBoxes(*scene);
    EXPECT_EQ(sums.count, 16);
    EXPECT_LT((sums.center - Vector3{0, 0, 0.6171}).length(), 1e-9);
    EXPECT_NEAR(sums.volume, 0.004038, 1e-9);
    EXPECT_LT((position(body(*scene, "ball::ball")) - Vector3{-0.182283, 0.297774, 0.05}).length(), 1e-9);
    EXPECT_LT((player("yellow_2") - Vector3{-0.392446, -0.0946615, 0.0381772}).length(), 1e-9);
    // Yaw -1.53192: its left side is towards +x.
    const Vector3 left = position(body(*scene, "blue_3::left_wheel")) - player("blue_3");
    EXPECT_NEAR(left.x, 0.045 * std::sin(1.53192), 1e-9);
    EXPECT_NEAR(left.z, -0.0176, 1e-9);
}

TEST_F(Soccer, PlayersDriveAtFullSpeedAndKeepersToAndFro) {
    runFor(*scene, 0.64);
    for (const char *name : {"blue_2", "yellow_1", "yellow_2"})
        EXPECT_NEAR(velocity(body(*scene, std::string(name) + "::body")).length(), 0.2, 0.02) << name;
    const double stroke = player("blue_3").y - 0.0459804;
    EXPECT_NEAR(stroke, -0.2 * 0.64, 0.02);
    runFor(*scene, 2.4 - 0.64);
    EXPECT_NEAR(player("blue_3").y, 0.0459804, 0.03);
}

TEST_F(Soccer, FirstCycleTurnsAfter49ControlSteps) {
    run(*scene, 2 * 49);
    EXPECT_EQ(wheelSpeed("blue_1", "left"), 10);
    run(*scene, 1);
    EXPECT_EQ(wheelSpeed("blue_1", "left"), -10);
    EXPECT_EQ(wheelSpeed("blue_1", "right"), 10);
    run(*scene, 2 * 51);
    EXPECT_EQ(wheelSpeed("blue_1", "left"), 10);
}

TEST_F(Soccer, LaterCyclesTurnAtRandomWithinBounds) {
    std::vector<int> straight;  // control steps of each cycle of blue_1
    run(*scene, 200);
    for (int cycle = 0; cycle < 20; ++cycle) {
        straight.push_back(0);
        for (int step = 0; step < 100; ++step) {
            run(*scene, 2);
            if (wheelSpeed("blue_1", "left") == 10) ++straight.back();
        }
        EXPECT_GE(straight.back(), 29);
        EXPECT_LE(straight.back(), 98);
    }
    EXPECT_GT(std::set<int>(straight.begin(), straight.end()).size(), 10u);
    // minstd_rand of seed 'b' + '1': 48271 · 147 = 7095837, and 29 + 7095837 mod 70 = 36.
    EXPECT_EQ(straight.front(), 36);
}

TEST_F(Soccer, StaysOnTheField) {
    runFor(*scene, 60);
    EXPECT_TRUE(isFinite(*scene));
    for (const char *name : players) {
        EXPECT_NEAR(player(name).z, 0.0375, 0.002) << name;
        EXPECT_LT(std::fabs(player(name).x), 0.86) << name;
        EXPECT_LT(std::fabs(player(name).y), 0.66) << name;
    }
    EXPECT_GT((position(body(*scene, "ball::ball")) - Vector3{-0.182283, 0.297774, 0.05}).length(), 0.1);
}

}  // namespace
