// The world yamor against its facts.
#include "small_world.h"

#include "loader/load_world.h"

#include <algorithm>

namespace {

using namespace small_world;

class Yamor : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> scene = worlds::loadWorld(worlds::findWorld("yamor"));

    dBodyID module(int i) const { return body(*scene, "chain::module_" + std::to_string(i) + "_body"); }
};

TEST_F(Yamor, HasTheObjectsOfTheFile) {
    EXPECT_EQ(staticGeoms(*scene), 1u);
    EXPECT_EQ(scene->inventory().bodies.size(), 16u);
    EXPECT_EQ(scene->inventory().joints.size(), 8u + 7u);
    EXPECT_NEAR(totalMass(*scene, "chain"), 8 * (0.17 + 0.016), 1e-9);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.008);
}

TEST_F(Yamor, CrawlsForwardInOnePiece) {
    runFor(*scene, 2);
    const double start = position(module(4)).x;
    double highest = 0;
    for (int i = 0; i < 625; ++i) {  // 5 s
        scene->frame();
        highest = std::max(highest, position(module(4)).z);
        for (int m = 1; m < 8; ++m)
            ASSERT_LT((position(module(m)) - position(module(m + 1))).length(), 0.13) << scene->time();
    }
    EXPECT_GT(position(module(4)).x - start, 1);
    EXPECT_NEAR(position(module(4)).y, 0, 0.01);
    EXPECT_GT(highest, 0.06);  // the wave lifts it off the floor
}

}  // namespace
