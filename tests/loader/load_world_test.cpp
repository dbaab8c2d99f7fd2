#include "loader/load_world.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

namespace {

TEST(WorldFolder, HoldsTheWorlds) {
    EXPECT_EQ(worlds::availableWorlds(),
              (std::vector<std::string>{"autonomous_vehicle", "bioloid", "blimp", "create", "darwin_op",
                                        "epuck", "epuck_line", "epucks", "gantry", "ghostdog", "hexapod",
                                        "hoap2_sumo", "hoap2_walk", "humanoid", "humanoids", "ipr_factory",
                                        "nao_demo", "pioneer3at", "salamander", "shrimp", "soccer", "sojourner",
                                        "stewart_platform", "surveyor", "uneven_terrain", "yamor", "youbot"}));
}

TEST(WorldFolder, FindsWorldsByNameAndByFile) {
    const std::string file = worlds::findWorld("create");
    EXPECT_EQ(file, worlds::worldFolder() + "/create.sdf");
    EXPECT_EQ(worlds::findWorld(file), file);
}

TEST(WorldFolder, NamesWhatExistsWhenThereIsNoSuchWorld) {
    try {
        worlds::findWorld("rugby");
        FAIL();
    } catch (const std::invalid_argument &error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("'rugby'"), std::string::npos) << message;
        EXPECT_NE(message.find("bioloid blimp create darwin_op epuck epuck_line epucks gantry"), std::string::npos)
            << message;
    }
}

TEST(WorldFolder, IsTheOneThatTheUserChose) {
    setenv("ODE_MT_WORLDS", "/dev/null/nowhere", 1);
    EXPECT_EQ(worlds::worldFolder(), "/dev/null/nowhere");
    EXPECT_TRUE(worlds::availableWorlds().empty());
    EXPECT_EQ(worlds::worldsInFolder(), "/dev/null/nowhere is not a folder");
    EXPECT_THROW(worlds::findWorld("create"), std::invalid_argument);
    setenv("ODE_MT_WORLDS", "/proc/self/task", 1);
    EXPECT_EQ(worlds::worldsInFolder(), "/proc/self/task holds no world");
    unsetenv("ODE_MT_WORLDS");
}

}  // namespace
