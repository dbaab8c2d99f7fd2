#include "world_spec.h"

#include <gtest/gtest.h>

using namespace bench;

namespace {

std::string complaint(const std::string &world) {
    try {
        loadOptions(readWorldSpec(world));
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "";
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
    EXPECT_NE(complaint("create:many").find("'many'"), std::string::npos);
    EXPECT_NE(complaint("create:0").find("'0'"), std::string::npos);
    EXPECT_NE(complaint("create:99999999999999999999").find("1000000"), std::string::npos);
    EXPECT_NE(complaint("create,sap").find("'sap'"), std::string::npos);
    EXPECT_EQ(complaint("create:620"), "");
}
