#include "world_source.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace bench;

namespace {

std::string complaint(const std::string &world) {
    try {
        checkWorld(world);
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(WorldSource, ModifiersBelongToTheSceneBeforeThem) {
    EXPECT_EQ(splitWorlds("rover,pile:40,quick,sap,create,a/b.sdf"),
              (std::vector<std::string>{"rover", "pile:40,quick,sap", "create", "a/b.sdf"}));
    EXPECT_EQ(splitWorlds("a\\,b.sdf,c\\,thesis\\,d.sdf,sap"),
              (std::vector<std::string>{"a\\,b.sdf", "c\\,thesis\\,d.sdf,sap"}));
    EXPECT_EQ(splitWorlds("create:620,static_meets_static,rover"),
              (std::vector<std::string>{"create:620,static_meets_static", "rover"}));
    EXPECT_TRUE(splitWorlds("").empty());
}

TEST(WorldSource, ARangeOfSizesIsOneWorldForEach) {
    EXPECT_EQ(
        splitWorlds("rover,pile:10..40,quick,create"),
        (std::vector<std::string>{"rover", "pile:10,quick", "pile:20,quick", "pile:40,quick", "create"}));
    EXPECT_NE(complaint(splitWorlds("pile:40..10").at(0)).find("'40..10'"), std::string::npos);
}

TEST(WorldSource, TheWorldsOfTheThesisAreEightThatExist) {
    const std::vector<std::string> worlds = splitWorlds("rover,thesis");
    ASSERT_EQ(worlds.size(), 9u);
    EXPECT_EQ(worlds.front(), "rover");
    for (const std::string &world : worlds) EXPECT_EQ(complaint(world), "");
}

TEST(WorldSource, SdfWorldsOpenWithTheStaticShapesAskedFor) {
    dInitODE2(0);
    std::vector<std::string> warnings;
    const auto count = [&](const std::string &world) {
        return openWorld(world, {}, warnings)->inventory().geoms.size();
    };
    EXPECT_EQ(count("pioneer3at:100"), count("pioneer3at") - 45 + 100);
    EXPECT_EQ(count("pioneer3at,static_meets_static"), count("pioneer3at"));
    EXPECT_THROW(count("pioneer3at:10"), std::runtime_error);
    dCloseODE();
}

TEST(WorldSource, ScenesAreKnown) {
    for (const scenes::SceneDescription &scene : scenes::availableScenes())
        EXPECT_EQ(complaint(scene.name + ":2,quick,hash"), "");
}

TEST(WorldSource, UnknownWorldsAreNamedWithThoseThatExist) {
    const std::string text = complaint("moon");
    EXPECT_NE(text.find("'moon'"), std::string::npos);
    EXPECT_NE(text.find("humanoids"), std::string::npos);
    EXPECT_NE(complaint("pile:many").find("'many'"), std::string::npos);
    EXPECT_NE(complaint("create:many").find("'many'"), std::string::npos);
    EXPECT_NE(complaint("no/such/file.sdf").find("no/such/file.sdf"), std::string::npos);
}

TEST(WorldSource, TheListNamesScenesAndModifiers) {
    const std::string list = listWorlds();
    for (const char *word :
         {"stacks", "vehicles_heightfield", "quadtree", "autodisable", "thesis", "static_meets_static"})
        EXPECT_NE(list.find(word), std::string::npos) << word;
}
