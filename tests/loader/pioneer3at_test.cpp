// The world pioneer3at against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <cmath>
#include <set>

namespace {

using namespace small_world;

class Pioneer3at : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("pioneer3at"));
};

TEST_F(Pioneer3at, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 45u);  // 40 posts, 4 walls, the floor
    EXPECT_EQ(scene->inventory().bodies.size(), 5u);
    EXPECT_EQ(scene->inventory().joints.size(), 4u);
    EXPECT_EQ(scene->inventory().geoms.size(), 45u + 18u);
    EXPECT_NEAR(totalMass(*scene, "robot"), 12.0, 1e-12);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.032);
}

TEST_F(Pioneer3at, PutsThePostsWhereTheFileHasThem) {
    const auto at = [&](const char *name) { return dGeomGetPosition(geom(*scene, name)); };
    const dReal *first = at("obstacles::posts::obstacle_1"), *last = at("obstacles::posts::obstacle_40");
    EXPECT_DOUBLE_EQ(first[0], 15.7489);
    EXPECT_DOUBLE_EQ(first[1], -12.6243);
    EXPECT_DOUBLE_EQ(last[0], -28.0377);
    EXPECT_DOUBLE_EQ(last[1], 9.77742);

    double sumX = 0, sumY = 0;
    for (int i = 1; i <= 40; ++i) {
        const dGeomID post = geom(*scene, "obstacles::posts::obstacle_" + std::to_string(i));
        dReal radius = 0, length = 0;
        dGeomCylinderGetParams(post, &radius, &length);
        EXPECT_EQ(radius, 0.4);
        EXPECT_EQ(length, 2);
        EXPECT_EQ(dGeomGetPosition(post)[2], 1);
        sumX += dGeomGetPosition(post)[0];
        sumY += dGeomGetPosition(post)[1];
    }
    EXPECT_NEAR(sumX, -0.62037, 1e-9);  // sums of the places in the Webots file
    EXPECT_NEAR(sumY, 70.12729, 1e-9);
}

TEST_F(Pioneer3at, DrivesStraightAtFirst) {
    const dBodyID base = body(*scene, "robot::base");
    runFor(*scene, 2);
    const Vector3 start = position(base);
    runFor(*scene, 2);
    EXPECT_NEAR((position(base) - start).length() / 2, 0.55, 0.01);
    EXPECT_NEAR(std::atan2(velocity(base).y, velocity(base).x), -1.09355, 0.01);
}

class TouchedGeoms : public scenes::Observer {
public:
    void contact(const dContact &contact) override { touched.insert({contact.geom.g1, contact.geom.g2}); }
    std::set<std::pair<dGeomID, dGeomID>> touched;
};

TEST_F(Pioneer3at, TouchesTheFloorAlone) {
    TouchedGeoms watch;
    scene->observe(&watch);
    runFor(*scene, 120);
    EXPECT_TRUE(isFinite(*scene));
    EXPECT_EQ(watch.touched.size(), 4u);  // four wheels
    const dGeomID ground = geom(*scene, "arena::ground::floor");
    for (const auto &[first, second] : watch.touched) EXPECT_TRUE(first == ground || second == ground);
}

}  // namespace
