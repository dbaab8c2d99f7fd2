// The worlds epuck and epucks against their facts.
#include "touched_models.h"

#include "loader/load_world.h"

#include <cmath>

namespace {

using namespace small_world;

constexpr double bodyRadius = 0.037;

class Epuck : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("epuck"));
    dBodyID robot = body(*scene, "robot::body");
};

TEST_F(Epuck, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 10u);  // floor, 4 walls, 5 boxes
    EXPECT_EQ(scene->inventory().bodies.size(), 3u);
    EXPECT_EQ(scene->inventory().joints.size(), 2u);
    EXPECT_EQ(scene->inventory().geoms.size(), 10u + 4u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 0.16, 1e-12);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.032);
    const Vector3 axle =
        position(body(*scene, "robot::left_wheel")) - position(body(*scene, "robot::right_wheel"));
    EXPECT_NEAR(axle.length(), 0.052, 1e-12);
    EXPECT_NEAR(position(robot).z, 0.015, 1e-12);  // its centre of mass
}

TEST_F(Epuck, DrivesFiguresOfEightInTheMiddle) {
    runFor(*scene, 2);
    EXPECT_NEAR(velocity(robot).length(), 0.107, 0.002);
    EXPECT_GT(spin(robot).z, 0.6);  // to the left at first
    runFor(*scene, 9.6);
    EXPECT_LT(spin(robot).z, -0.6);

    Vector3 least = position(robot), most = least;
    TouchedModels watch(*scene);
    scene->observe(&watch);
    for (int i = 0; i < 1900; ++i) {  // 61 s
        scene->frame();
        least = minOf(least, position(robot));
        most = maxOf(most, position(robot));
    }
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_NEAR(most.y - least.y, 0.65, 0.05);  // two circles side by side
    EXPECT_LT(least.length() + bodyRadius, 0.42);
    EXPECT_LT(most.length() + bodyRadius, 0.42);
    EXPECT_EQ(watch.pairs.size(), 1u);  // the robot and the arena
    EXPECT_NEAR(position(robot).z, 0.015, 5e-4);
}

class Epucks : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("epucks"));

    static std::string name(const char *team, int number) { return team + std::to_string(number); }
    dBodyID robot(const char *team, int number) const { return body(*scene, name(team, number) + "::body"); }
};

TEST_F(Epucks, AreSixteenOnAFieldForSoccer) {
    EXPECT_EQ(staticGeoms(*scene), 17u);
    EXPECT_EQ(scene->inventory().bodies.size(), 16u * 3);
    EXPECT_EQ(scene->inventory().joints.size(), 16u * 2);
    EXPECT_EQ(scene->inventory().geoms.size(), 17u + 16u * 4);
    for (const char *team : {"blue_", "yellow_"})
        for (int i = 1; i <= 8; ++i) EXPECT_NEAR(totalMass(*scene, name(team, i)), 0.16, 1e-12);
}

TEST_F(Epucks, CircleInStepAndTouchNothingButTheField) {
    const Vector3 apart = position(robot("blue_", 1)) - position(robot("blue_", 8));
    const Vector3 start = position(robot("blue_", 1));
    TouchedModels watch(*scene);
    scene->observe(&watch);
    double farthest = 0;
    for (int i = 0; i < 1875; ++i) {  // 60 s
        scene->frame();
        farthest = std::max(farthest, (position(robot("blue_", 1)) - start).length());
        ASSERT_LT((position(robot("blue_", 1)) - position(robot("blue_", 8)) - apart).length(), 1e-6);
    }
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_NEAR(farthest, 0.16, 0.02);  // the width of the circle
    EXPECT_NEAR(velocity(robot("yellow_", 3)).length(), 0.093, 0.002);
    EXPECT_EQ(watch.pairs.size(), 16u);
    for (const auto &[first, second] : watch.pairs) EXPECT_TRUE(first == "field" || second == "field");
}

}  // namespace
