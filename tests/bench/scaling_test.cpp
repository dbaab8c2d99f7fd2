#include "report.h"
#include "scaling.h"

#include <gtest/gtest.h>

using namespace bench;

namespace {

std::vector<Engine> engines(const std::vector<std::string> &names) {
    std::vector<Engine> engines;
    for (const std::string &name : names) engines.push_back(readEngine(name));
    return engines;
}

// A frame takes 1 s on one thread, and 1 / threads on more.
WorldResult worldResult(const std::string &world, const std::vector<std::string> &names) {
    WorldResult result;
    result.world = world;
    result.rounds = 1;
    result.frames = 100;
    for (const Engine &engine : engines(names)) {
        EngineResult run;
        run.engine = engine;
        const double threads = engine.isOurs() && engine.threads != "0" ? std::stod(engine.threads) : 1;
        Batch batch;
        batch.frames = 100;
        batch.seconds = {0, 50 / threads, 50 / threads, 0};
        run.batches.push_back(batch);
        for (Part part : kParts)
            run.averages[static_cast<std::size_t>(part)].add(100, secondsOf(batch.seconds, part));
        result.engines.push_back(run);
    }
    return result;
}

}  // namespace

TEST(Scaling, IsOfEnginesThatDifferInNothingButTheirThreads) {
    const std::vector<Scaling> scalings =
        scalingsOf(engines({"stock", "ours:8", "ours:0", "ours:2/independent", "stock-pool:2", "ours:auto", "ours:2",
                            "ours:4/independent", "ours:2", "ours:2/lcp"}));
    ASSERT_EQ(scalings.size(), 2u);
    EXPECT_EQ(scalings[0].engine, "ours:N");
    ASSERT_EQ(scalings[0].points.size(), 3u);
    EXPECT_EQ(scalings[0].points[0].threads, 0u);
    EXPECT_EQ(scalings[0].points[0].engine, 2u);
    EXPECT_EQ(scalings[0].points[1].engine, 6u) << "the first of two";
    EXPECT_EQ(scalings[0].points[2].threads, 8u);
    EXPECT_EQ(scalings[1].engine, "ours:N/independent");
}

TEST(Scaling, TakesTwoNumbersOfThreads) {
    EXPECT_TRUE(scalingsOf(engines({"stock", "ours:2", "stock-pool:2"})).empty());
    EXPECT_EQ(reportScaling({worldResult("pile:4", {"stock", "ours:2"})}), "");
    EXPECT_EQ(reportScaling({}), "");
}

TEST(Scaling, IsATableOfAllWorlds) {
    const std::vector<std::string> names = {"stock", "ours:0", "ours:2", "ours:16"};
    WorldResult failed = worldResult("soccer", names);
    failed.engines[2].failure = "crashed";
    const std::string text = reportScaling({worldResult("pile:4", names), failed});
    EXPECT_NE(text.find("ours:N: speed-up over stock, by threads"), std::string::npos) << text;
    EXPECT_NE(text.find("frame: 0"), std::string::npos) << text;
    EXPECT_NE(text.find("16.0"), std::string::npos) << text;
    const std::string soccer = text.substr(text.find("soccer"));
    EXPECT_NE(soccer.find("-"), std::string::npos) << text;
}
