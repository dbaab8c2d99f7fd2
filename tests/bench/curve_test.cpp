#include "curve.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "report.h"

using namespace bench;

namespace {

EngineResult engineResult(const std::string &name, double collideSeconds, double stepSeconds) {
    EngineResult engine;
    engine.engine = readEngine(name);
    engine.ready.stepSize = 0.01;
    Batch batch;
    batch.frames = 100;
    batch.seconds.collide = 100 * collideSeconds;
    batch.seconds.step = 100 * stepSeconds;
    engine.batches = {batch};
    for (Part part : kParts)
        engine.averages[static_cast<std::size_t>(part)].add(100, secondsOf(batch.seconds, part));
    return engine;
}

// Collision of the first engine is quadratic, of the second linear; the steps of both take 1 ms.
WorldResult worldResult(const std::string &world, double size) {
    WorldResult result;
    result.world = world;
    result.engines = {engineResult("stock", 1e-9 * size * size, 1e-3),
                      engineResult("ours:2", 1e-6 * size, 1e-3)};
    result.rounds = 1;
    return result;
}

std::vector<WorldResult> threeSizes() {
    return {worldResult("pile:1000,sap", 1000), worldResult("rover", 1), worldResult("pile:4000,sap", 4000),
            worldResult("pile:2000,sap", 2000)};
}

}  // namespace

TEST(Curve, IsOfWorldsThatDifferInNothingButTheirSize) {
    EXPECT_TRUE(curvesOf({}).empty());
    EXPECT_TRUE(curvesOf({worldResult("rover", 1), worldResult("rover:20", 20)}).empty());
    EXPECT_TRUE(curvesOf({worldResult("pile:10", 10), worldResult("pile:20,sap", 20)}).empty());
    EXPECT_TRUE(curvesOf({worldResult("pile:10", 10), worldResult("pile:10", 10)}).empty());
    std::vector<WorldResult> results = threeSizes();
    results.push_back(worldResult("stacks:4", 4));
    results.push_back(worldResult("stacks:8", 8));
    const std::vector<Curve> curves = curvesOf(results);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].world, "pile:N,sap");
    EXPECT_EQ(curves[1].world, "stacks:N");
}

TEST(Curve, RisesInSize) {
    const Curve curve = curvesOf(threeSizes()).at(0);
    ASSERT_EQ(curve.points.size(), 3u);
    EXPECT_EQ(curve.points[0].size, 1000);
    EXPECT_EQ(curve.points[1].size, 2000);
    EXPECT_EQ(curve.points[2].size, 4000);
    EXPECT_DOUBLE_EQ(curve.seconds(Part::Collision, 1, 0), 4e-3);
    EXPECT_DOUBLE_EQ(curve.seconds(Part::Frame, 1, 1), 3e-3);
}

TEST(Curve, GrowthIsThePowerOfTheSize) {
    const Curve curve = curvesOf(threeSizes()).at(0);
    EXPECT_TRUE(std::isnan(curve.growth(Part::Collision, 0, 0)));
    for (const std::size_t point : {1, 2}) {
        EXPECT_NEAR(curve.growth(Part::Collision, point, 0), 2, 1e-9);
        EXPECT_NEAR(curve.growth(Part::Collision, point, 1), 1, 1e-9);
    }
    EXPECT_NEAR(curve.growth(Part::Frame, 1, 1), std::log2(1.5), 1e-9);
    const Curve tenfold = curvesOf({worldResult("pile:10", 10), worldResult("pile:100", 100)}).at(0);
    EXPECT_NEAR(tenfold.growth(Part::Collision, 1, 0), 2, 1e-9);
}

TEST(Curve, AFailedEngineHasNoTimeAndNoGrowthThereAndAfter) {
    std::vector<WorldResult> results = threeSizes();
    results[3].engines[0].failure = "gave no answer";
    const Curve curve = curvesOf(results).at(0);
    EXPECT_TRUE(std::isnan(curve.seconds(Part::Frame, 1, 0)));
    EXPECT_TRUE(std::isnan(curve.growth(Part::Frame, 1, 0)));
    EXPECT_TRUE(std::isnan(curve.growth(Part::Frame, 2, 0)));
    EXPECT_NEAR(curve.growth(Part::Collision, 2, 1), 1, 1e-9);
}

TEST(Curve, ThePlaceOfAWorldIsFound) {
    const std::vector<Curve> curves = curvesOf(threeSizes());
    ASSERT_TRUE(findInCurves(curves, "pile:2000,sap"));
    EXPECT_EQ(findInCurves(curves, "pile:2000,sap")->point, 1u);
    EXPECT_FALSE(findInCurves(curves, "pile:3000,sap"));
    EXPECT_FALSE(findInCurves(curves, "pile:2000"));
    EXPECT_FALSE(findInCurves(curves, "rover"));
}

TEST(Curve, IsATableForEachWorld) {
    EXPECT_EQ(reportCurves({worldResult("pile:10", 10)}), "");
    EXPECT_EQ(
        reportCurves(threeSizes()),
        "== pile:N,sap: time over size ==\n\n"
        "   N  collision ms: stock  growth  ours:2  growth  frame ms: stock  growth  ours:2  growth\n"
        "----  -------------------  ------  ------  ------  ---------------  ------  ------  ------\n"
        "1000                 1.00            1.00                     2.00            2.00\n"
        "2000                 4.00    2.00    2.00    1.00             5.00    1.32    3.00    0.58\n"
        "4000                 16.0    2.00    4.00    1.00             17.0    1.77    5.00    0.74\n\n");
}

TEST(Curve, StandsInTheJsonFile) {
    EXPECT_TRUE(nlohmann::json::parse(reportJson({worldResult("rover", 1)}))["curves"].empty());
    const auto curves = nlohmann::json::parse(reportJson(threeSizes()))["curves"];
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0]["world"], "pile:N,sap");
    EXPECT_EQ(curves[0]["sizes"], nlohmann::json({1000, 2000, 4000}));
    const auto &stock = curves[0]["engines"][0];
    EXPECT_EQ(stock["engine"], "stock");
    EXPECT_DOUBLE_EQ(stock["parts"]["collision"]["meanSeconds"][2], 16e-3);
    EXPECT_TRUE(stock["parts"]["frame"]["growth"][0].is_null());
    EXPECT_NEAR(stock["parts"]["collision"]["growth"][1], 2, 1e-9);
}

TEST(Curve, StandsAtTheEndOfLinesOfTheCsvFile) {
    EXPECT_EQ(reportCsv({worldResult("pile:10", 10)}).find("growth"), std::string::npos);
    std::istringstream lines(reportCsv(threeSizes()));
    std::vector<std::string> ends;
    for (std::string line; std::getline(lines, line);) {
        std::size_t comma = line.size();
        for (int i = 0; i < 3; ++i) comma = line.rfind(',', comma - 1);
        ends.push_back(line.substr(comma));
    }
    EXPECT_EQ(ends, (std::vector<std::string>{",size,collision_growth,frame_growth", ",1000,,", ",1000,,",
                                              ",,,", ",,,", ",4000,2,1.76553475", ",4000,1,0.736965594",
                                              ",2000,2,1.32192809", ",2000,1,0.584962501"}));
}

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
