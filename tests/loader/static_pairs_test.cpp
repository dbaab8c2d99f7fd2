// Pairs of static shapes: excluded by ODE's space, or reported and dropped. The motion is the same.
#include "small_world.h"

#include "loader/load_world.h"
#include "scenes/state_hash.h"

namespace {

using namespace small_world;

class CountStaticPairs : public scenes::Observer {
public:
    void nearPair(dGeomID o1, dGeomID o2) override { count += !dGeomGetBody(o1) && !dGeomGetBody(o2); }
    int count = 0;
};

struct Outcome {
    std::uint64_t hash;
    int staticPairs;
};

Outcome outcome(worlds::SdfScene &scene, int frames) {
    CountStaticPairs watch;
    scene.observe(&watch);
    run(scene, frames);
    return {scenes::stateHash(scene.inventory()), watch.count};
}

worlds::LoadOptions meeting() {
    worlds::LoadOptions options;
    options.staticMeetsStatic = true;
    return options;
}

class StaticPairs : public testing::TestWithParam<const char *> {};

TEST_P(StaticPairs, ChangeNoBit) {
    const std::string file = worlds::findWorld(GetParam());
    const Outcome apart = outcome(*worlds::loadWorld(file), 500);
    const Outcome together = outcome(*worlds::loadWorld(file, meeting()), 500);
    EXPECT_EQ(apart.staticPairs, 0);
    EXPECT_GT(together.staticPairs, 500);
    EXPECT_EQ(apart.hash, together.hash);
}

INSTANTIATE_TEST_SUITE_P(Worlds, StaticPairs, testing::Values("pioneer3at", "create"),
                         [](const auto &info) { return std::string(info.param); });

std::string maskedBox(const std::string &name, const std::string &mask) {
    return "<model name=\"" + name +
           "\"><static>true</static><link name=\"link\"><collision name=\"shape\"><geometry>" + box(1, 1, 1) +
           "</geometry><surface><contact>" + mask + "</contact></surface></collision></link></model>";
}

const std::string one = "<collide_bitmask>1</collide_bitmask>", two = "<collide_bitmask>2</collide_bitmask>";

TEST(StaticPairMasks, HoldBetweenStaticShapesThatMeet) {
    const auto pairs = [](const std::string &first, const std::string &second) {
        return outcome(*load(world(maskedBox("a", first) + maskedBox("b", second)), meeting()), 1)
            .staticPairs;
    };
    EXPECT_EQ(pairs(one, one), 1);
    EXPECT_EQ(pairs(one, two), 0);
    EXPECT_EQ(pairs(one, two + "<category_bitmask>1</category_bitmask>"), 1);
}

TEST(StaticPairMasks, HoldAgainstMovingShapesEitherWay) {
    const auto contacts = [](const std::string &still, const std::string &moving, bool meets) {
        const auto scene =
            load(world(maskedBox("a", still) + model("m", "0 0 0.55 0 0 0", sphere(0.1),
                                                     "<surface><contact>" + moving + "</contact></surface>")),
                 meets ? meeting() : worlds::LoadOptions());
        scene->frame();
        return scene->contactCount();
    };
    for (const bool meets : {false, true}) {
        EXPECT_EQ(contacts(one, one, meets), 1u);
        EXPECT_EQ(contacts(one, two, meets), 0u);
        EXPECT_EQ(contacts(one, two + "<category_bitmask>1</category_bitmask>", meets), 1u);
        EXPECT_EQ(contacts(two + "<category_bitmask>1</category_bitmask>", one, meets), 1u);
    }
}

}  // namespace
