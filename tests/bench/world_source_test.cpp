#include "world_source.h"

#include <gtest/gtest.h>

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
    EXPECT_TRUE(splitWorlds("").empty());
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
    EXPECT_NE(complaint("no/such/file.sdf").find("no/such/file.sdf"), std::string::npos);
}

TEST(WorldSource, TheListNamesScenesAndModifiers) {
    const std::string list = listWorlds();
    for (const char *word : {"stacks", "vehicles_heightfield", "quadtree", "autodisable"})
        EXPECT_NE(list.find(word), std::string::npos) << word;
}
