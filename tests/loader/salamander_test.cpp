// The world salamander against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class Salamander : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("salamander"));
    dBodyID head = body(*scene, "salamander::head"), pelvis = body(*scene, "salamander::pelvis");
};

TEST_F(Salamander, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 9u);
    EXPECT_EQ(scene->inventory().bodies.size(), 9u + 4u);
    EXPECT_EQ(scene->inventory().joints.size(), 12u);
    EXPECT_NEAR(totalMass(*scene, "salamander"), 7 * 0.180281 + 2 * 0.279137 + 4 * (0.00242371 + 0.0045704),
                1e-6);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.004);
}

TEST_F(Salamander, WalksDownTheRampAndThenSwims) {
    runFor(*scene, 1);
    const double start = position(head).y;
    runFor(*scene, 5);
    EXPECT_NEAR(position(head).y - start, 2.1, 0.3);  // 0.42 m/s
    EXPECT_LT(position(head).z, 0.16);

    // The water carries it, between the surface and the ground, which is 0.16 m below it and more.
    runFor(*scene, 11);
    const double afloat = position(head).y;
    for (int i = 0; i < 1000; ++i) {  // 4 s
        scene->frame();
        ASSERT_GT(position(pelvis).z, -0.14) << scene->time();
        ASSERT_LT(position(pelvis).z, 0) << scene->time();
    }
    EXPECT_GT(position(head).y - afloat, 0.9);
}

}  // namespace
