// What is said of a world.
#include "top/frame_text.h"

#include <gtest/gtest.h>

#include "world_frames.h"

namespace {

std::string join(const std::vector<std::string> &lines) {
    std::string text;
    for (const std::string &line : lines) text += line + '\n';
    return text;
}

TEST(FrameText, HasARowForEachWorld) {
    top::WorldFrames world = worldFrames(0, 4711, 1, 101);
    world.statistics.bodies = 80;
    world.statistics.contactsAhead = 50;
    world.statistics.hitRate = 0.98;
    world.statistics.collisionThreads = 2;
    world.statistics.stepThreads = 1;
    const auto lines = top::tableOf(top::ratesOfAll({world, worldFrames(1, 4711, 2, 11)}));
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_NE(lines[0].find("world  process  frames  a second  frame ms  collide ms  step ms"), std::string::npos) << lines[0];
    EXPECT_NE(lines[2].find("1     4711     101     100.0    10.000       2.000    5.000"), std::string::npos) << lines[2];
    EXPECT_NE(lines[2].find("98 %"), std::string::npos);
    EXPECT_NE(lines[2].find("2+1"), std::string::npos);
    EXPECT_NE(lines[3].find(" - "), std::string::npos) << "no contacts ahead, no hits";
}

TEST(FrameText, SaysWhyItIsOneThread) {
    top::WorldFrames world = worldFrames(0, 1, 3, 4);
    world.statistics.collisions = 1;
    world.statistics.collisionThreads = 2;
    world.statistics.collisionTime = 0.002;
    world.statistics.broadPhaseTime = 0.0005;
    world.statistics.callbackReason = dODE_MT_REASON_CALLBACK_POLICY;
    world.statistics.stepReason = dODE_MT_REASON_SMALL_ISLAND;
    world.statistics.stepThreads = 1;
    const std::string text = join(top::detailsOf(top::ratesOfAll({world})[0]));
    EXPECT_NE(text.find("world 3, last frame"), std::string::npos) << text;
    EXPECT_NE(text.find("collide  2.000 ms: broad phase 0.500\n"), std::string::npos) << text;
    EXPECT_NE(text.find("pairs: 2 threads (on several in 50 %)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("near-callbacks: one thread, as the callback policy is \"serial\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("islands: one thread, as there is one island, too small for several threads (on several in 25 %)\n"), std::string::npos)
        << text;

    world.statistics.collisionReason = world.statistics.callbackReason = dODE_MT_REASON_FEW_GEOMS;
    world.statistics.collisionThreads = 1;
    EXPECT_NE(join(top::detailsOf(top::ratesOfAll({world})[0])).find("pairs and near-callbacks: one thread, as the space has too few geoms"),
              std::string::npos);
}

TEST(FrameText, SaysWhatWorkersInOtherProcessesDo) {
    top::WorldFrames world = worldFrames(0, 1, 1, 4);
    EXPECT_EQ(join(top::detailsOf(top::ratesOfAll({world})[0])).find("remote"), std::string::npos);
    world.statistics.remoteWorkers = 3;
    world.statistics.remoteIslands = 40;
    world.statistics.allRemoteIslands = 150;
    EXPECT_NE(join(top::detailsOf(top::ratesOfAll({world})[0]))
                  .find("remote workers: 3; solved 40 islands, 0 more at home after all (of all frames 150, 0)\n"),
              std::string::npos);
    world.statistics.remoteWorkers = 0;
    world.statistics.remoteWorkersLost = 3;
    world.statistics.returnedIslands = 7;
    world.statistics.allReturnedIslands = 9;
    EXPECT_NE(join(top::detailsOf(top::ratesOfAll({world})[0]))
                  .find("remote workers: 0, 3 lost; solved 40 islands, 7 more at home after all (of all frames 150, 9)\n"),
              std::string::npos);
}

TEST(FrameText, SaysThatThereIsNoWorldOrNoRoomForMore) {
    EXPECT_EQ(top::textOf({}, 0), std::string(top::kNoWorld) + '\n');
    const std::string text = top::textOf(top::ratesOfAll({worldFrames(0, 1, 1, 4)}), 5);
    EXPECT_NE(text.find("\n5 further worlds are not shown\n"), std::string::npos);
}

}  // namespace
