#include "world_source.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace bench;

using Worlds = std::vector<std::string>;

TEST(SizeRange, SizesDouble) {
    EXPECT_EQ(expandSizes("pile:1000..4000"), (Worlds{"pile:1000", "pile:2000", "pile:4000"}));
    EXPECT_EQ(expandSizes("pile:3..23,sap,quick"),
              (Worlds{"pile:3,sap,quick", "pile:6,sap,quick", "pile:12,sap,quick"}));
    EXPECT_EQ(expandSizes("pile:5..5"), (Worlds{"pile:5"}));
    EXPECT_EQ(expandSizes("a:b/world.sdf:7..14"), (Worlds{"a:b/world.sdf:7", "a:b/world.sdf:14"}));
}

TEST(SizeRange, AWorldWithoutARangeIsItself) {
    for (const char *world : {"rover", "pile:4000", "pile:4000,sap", "../a/b.sdf", "../a/b.sdf:40", ""})
        EXPECT_EQ(expandSizes(world), Worlds{world});
}

TEST(SizeRange, ARangeThatMakesNoSenseIsLeftToBeComplainedOf) {
    for (const char *world : {"pile:4..2", "pile:0..2", "pile:..2", "pile:2..", "pile:2..x", "pile:-1..2",
                              "pile:1...4", "pile:1..99999999999"})
        EXPECT_EQ(expandSizes(world), Worlds{world});
}

namespace {

// What a call throws std::invalid_argument with; empty if it does not.
template <class Call>
std::string complaintOf(const Call &call) {
    try {
        call();
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "";
}

std::string complaintOfOptions(const std::string &world) {
    return complaintOf([&] { loadOptions(readWorldSpec(world)); });
}

std::string complaint(const std::string &world) {
    return complaintOf([&] { checkWorld(world); });
}

}  // namespace

TEST(WorldSpec, HasNameSizeAndModifiers) {
    const WorldSpec spec = readWorldSpec("pioneer3at:440,static_meets_static");
    EXPECT_EQ(spec.name, "pioneer3at");
    EXPECT_EQ(spec.size, "440");
    EXPECT_EQ(spec.modifiers, (std::vector<std::string>{"static_meets_static"}));
    EXPECT_TRUE(spec.isSdf);
    EXPECT_EQ(loadOptions(spec).staticShapes, 440u);
    EXPECT_TRUE(loadOptions(spec).staticMeetsStatic);
    EXPECT_EQ(loadOptions(readWorldSpec("create")).staticShapes, 0u);
    EXPECT_FALSE(loadOptions(readWorldSpec("create")).staticMeetsStatic);
}

TEST(WorldSpec, FilesMayHaveSizesAndColons) {
    EXPECT_EQ(readWorldSpec("my/world.sdf:20").name, "my/world.sdf");
    EXPECT_EQ(readWorldSpec("my/world.sdf:20").size, "20");
    EXPECT_EQ(readWorldSpec("my:folder/world.sdf").name, "my:folder/world.sdf");
    EXPECT_TRUE(readWorldSpec("my:folder/world.sdf").size.empty());
}

TEST(WorldSpec, ACommaInTheNameOfAFileIsEscaped) {
    const WorldSpec spec = readWorldSpec("my/a\\,b\\c.sdf:20,static_meets_static");
    EXPECT_EQ(spec.name, "my/a,b\\c.sdf");
    EXPECT_EQ(spec.size, "20");
    EXPECT_EQ(spec.modifiers, (std::vector<std::string>{"static_meets_static"}));
}

TEST(WorldSpec, ANameOfBothIsTheSceneOnceItHasASceneSizeOrModifier) {
    for (const char *name : {"soccer", "humanoids"}) {
        EXPECT_TRUE(readWorldSpec(name).isSdf);
        EXPECT_TRUE(readWorldSpec(std::string(name) + ",static_meets_static").isSdf);
        EXPECT_FALSE(readWorldSpec(std::string(name) + ":4").isSdf);
        EXPECT_FALSE(readWorldSpec(std::string(name) + ",quick").isSdf);
    }
    EXPECT_FALSE(readWorldSpec("stacks:3,sap").isSdf);
}

TEST(WorldSpec, WrongSizesAndModifiersAreNamed) {
    EXPECT_NE(complaintOfOptions("create:many").find("'many'"), std::string::npos);
    EXPECT_NE(complaintOfOptions("create:0").find("'0'"), std::string::npos);
    EXPECT_NE(complaintOfOptions("create:99999999999999999999").find("1000000"), std::string::npos);
    EXPECT_NE(complaintOfOptions("create,sap").find("'sap'"), std::string::npos);
    EXPECT_EQ(complaintOfOptions("create:620"), "");
}

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
