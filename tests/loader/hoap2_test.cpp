// The worlds hoap2_walk and hoap2_sumo against their facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

std::unique_ptr<worlds::SdfScene> loadNamed(const std::string &name) {
    return worlds::loadWorld(worlds::findWorld(name));
}

double upright(dBodyID body) { return dBodyGetRotation(body)[10]; }

TEST(Hoap2, HasTheObjectsOfTheFile) {
    const auto walk = loadNamed("hoap2_walk"), sumo = loadNamed("hoap2_sumo");
    EXPECT_EQ(staticGeoms(*walk), 1u);
    EXPECT_EQ(staticGeoms(*sumo), 2u);
    EXPECT_DOUBLE_EQ(walk->stepSize(), 0.025);
    EXPECT_DOUBLE_EQ(sumo->stepSize(), 0.016);
    for (const worlds::SdfScene *scene : {walk.get(), sumo.get()}) {
        EXPECT_EQ(scene->inventory().bodies.size(), 28u);
        EXPECT_EQ(scene->inventory().joints.size(), 25u + 2u);
        EXPECT_NEAR(totalMass(*scene, "robot"), 7.16, 0.001);
    }
}

TEST(Hoap2, WalksStraightAhead) {
    const auto scene = loadNamed("hoap2_walk");
    const dBodyID trunk = body(*scene, "robot::body"), sole = body(*scene, "robot::left_sole");
    runFor(*scene, 3);
    const Vector3 start = position(trunk);
    int steps = 0;
    for (int i = 0; i < 400; ++i) {  // 10 s, 7 strides
        const bool before = position(sole).z > 0.0135;
        scene->frame();
        steps += !before && position(sole).z > 0.0135;
        ASSERT_GT(upright(trunk), 0.97) << scene->time();
    }
    EXPECT_EQ(steps, 7);
    EXPECT_NEAR((position(trunk) - start).x, 0.56, 0.1);  // 8 cm a stride
    EXPECT_NEAR((position(trunk) - start).y, 0, 0.1);
}

TEST(Hoap2, StampsWithBothFeetInTurn) {
    const auto scene = loadNamed("hoap2_sumo");
    const dBodyID trunk = body(*scene, "robot::body");
    const dBodyID left = body(*scene, "robot::left_sole"), right = body(*scene, "robot::right_sole");
    double lowest = 1, highestLeft = 0, highestRight = 0;
    while (scene->time() < 14) {
        scene->frame();
        lowest = std::min(lowest, position(trunk).z);
        const bool isLeftsTurn = scene->time() < 7;
        double &highest = isLeftsTurn ? highestLeft : highestRight;
        highest = std::max(highest, position(isLeftsTurn ? left : right).z);
        ASSERT_LT(position(isLeftsTurn ? right : left).z, 0.22) << scene->time();  // on the stage
        ASSERT_GT(upright(trunk), 0.98) << scene->time();
    }
    EXPECT_LT(lowest, 0.515);  // squats from 0.55
    EXPECT_GT(highestLeft, 0.235);
    EXPECT_GT(highestRight, 0.235);
    EXPECT_LT((position(trunk) - Vector3{-0.53, 0, 0.55}).length(), 0.05);
}

}  // namespace
