// The worlds humanoid and humanoids against their facts.
#include "touched_models.h"

#include "loader/load_world.h"

#include <cmath>

namespace {

using namespace small_world;

std::unique_ptr<worlds::SdfScene> loadNamed(const std::string &name) {
    return worlds::loadWorld(worlds::findWorld(name));
}

// Returns 1 when it is upright.
double upright(dBodyID body) { return dBodyGetRotation(body)[10]; }

class Humanoid : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = loadNamed("humanoid");
    dBodyID trunk = body(*scene, "robot::body");

    double angle(const std::string &name) const {
        return dJointGetHingeAngle(joint(*scene, "robot::" + name + "_joint"));
    }
};

TEST_F(Humanoid, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 5u);
    EXPECT_EQ(scene->inventory().bodies.size(), 18u);
    EXPECT_EQ(scene->inventory().joints.size(), 17u);
    EXPECT_EQ(scene->inventory().geoms.size(), 5u + 67u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 1.624, 1e-12);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.032);
    EXPECT_DOUBLE_EQ(dWorldGetERP(scene->inventory().worlds[0]), 0.5);
    EXPECT_DOUBLE_EQ(dWorldGetAutoDisableLinearThreshold(scene->inventory().worlds[0]), 0.05);
}

TEST_F(Humanoid, IsAsTallAsTheFileHasIt) {
    dReal head[6], foot[6];
    dGeomGetAABB(geom(*scene, "robot::head::box_1"), head);
    dGeomGetAABB(geom(*scene, "robot::left_foot::box_1"), foot);
    EXPECT_NEAR(head[5] - foot[4], 0.3474, 1e-4);
    EXPECT_NEAR(foot[4], -0.0004, 1e-4);  // on the soft floor it penetrates by 0.4 mm
}

TEST_F(Humanoid, BothSidesMirrorEachOther) {
    for (const char *part : {"hip", "thigh", "shank", "ankle", "foot", "shoulder", "arm", "hand"}) {
        const Vector3 left = position(body(*scene, std::string("robot::left_") + part));
        const Vector3 right = position(body(*scene, std::string("robot::right_") + part));
        EXPECT_LT((left - Vector3{right.x, -right.y, right.z}).length(), 1e-12) << part;
    }
}

TEST_F(Humanoid, BendsItsKneesOnceASecondAndMovesItsArms) {
    runFor(*scene, 1);
    EXPECT_NEAR(angle("left_shank"), 0, 0.02);
    const double standing = position(trunk).z;
    double lowest = standing, maxKnee = 0, minReach = 0, maxReach = 0;
    int bends = 0;
    for (int i = 0; i < 250; ++i) {  // 8 s, two bars
        const double before = angle("left_shank");
        scene->frame();
        const double after = angle("left_shank");
        bends += before < 0.8 && after >= 0.8;
        maxKnee = std::max(maxKnee, after);
        lowest = std::min(lowest, position(trunk).z);
        minReach = std::min(minReach, angle("left_shoulder"));
        maxReach = std::max(maxReach, angle("left_arm"));
    }
    EXPECT_EQ(bends, 8);
    EXPECT_GT(maxKnee, 1.3);  // of 1.6: the servos lag
    EXPECT_LT(lowest, standing - 0.025);
    EXPECT_LT(minReach, -1.5);
    EXPECT_GT(maxReach, 1);
}

TEST_F(Humanoid, StaysUprightOnItsFeet) {
    TouchedModels watch(*scene);
    scene->observe(&watch);
    for (int i = 0; i < 1875; ++i) {  // 60 s
        scene->frame();
        ASSERT_GT(upright(trunk), 0.99) << scene->time();
    }
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_EQ(watch.pairs.size(), 1u);
    EXPECT_LT(std::hypot(position(trunk).x, position(trunk).y), 0.05);
    for (const char *foot : {"robot::left_foot", "robot::right_foot"})
        EXPECT_NEAR(upright(body(*scene, foot)), 1, 0.02);
}

TEST(Humanoids, AreEight) {
    const auto scene = loadNamed("humanoids");
    EXPECT_EQ(staticGeoms(*scene), 5u);
    EXPECT_EQ(scene->inventory().bodies.size(), 8u * 18);
    EXPECT_EQ(scene->inventory().joints.size(), 8u * 17);
    EXPECT_EQ(scene->inventory().geoms.size(), 5u + 8u * 67);
    for (int i = 1; i <= 8; ++i) EXPECT_NEAR(totalMass(*scene, "robot_" + std::to_string(i)), 1.624, 1e-12);
}

TEST(Humanoids, DanceInStepAndNeverTouchEachOther) {
    const auto scene = loadNamed("humanoids");
    const dBodyID first = body(*scene, "robot_1::left_hand"), last = body(*scene, "robot_8::left_hand");
    const Vector3 apart = position(first) - position(last);
    TouchedModels watch(*scene);
    scene->observe(&watch);
    for (int i = 0; i < 1875; ++i) {  // 60 s
        scene->frame();
        ASSERT_LT((position(first) - position(last) - apart).length(), 1e-6) << scene->time();
    }
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_EQ(watch.pairs.size(), 8u);  // each with the arena
    for (const auto &[one, other] : watch.pairs) EXPECT_TRUE(one == "arena" || other == "arena");
    for (int i = 1; i <= 8; ++i)
        EXPECT_GT(upright(body(*scene, "robot_" + std::to_string(i) + "::body")), 0.99);
}

}  // namespace
