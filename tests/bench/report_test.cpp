#include "report.h"
#include "summary.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace bench;

namespace {

EngineResult engineResult(const std::string &name, const std::vector<double> &stepSeconds) {
    EngineResult engine;
    engine.engine = readEngine(name);
    engine.ready.stepSize = 0.01;
    for (double seconds : stepSeconds) {
        Batch batch;
        batch.frames = 100;
        batch.seconds = {0, seconds, seconds, 0};
        batch.hash = 0xabc;
        engine.batches.push_back(batch);
        for (Part part : kParts)
            engine.averages[static_cast<std::size_t>(part)].add(100, secondsOf(batch.seconds, part));
    }
    return engine;
}

// Ours is twice as fast in two rounds and four times in one.
WorldResult worldResult() {
    WorldResult result;
    result.world = "pile:4,sap";
    result.engines = {engineResult("stock", {0.2, 0.2, 0.4}), engineResult("ours:2", {0.1, 0.1, 0.1})};
    result.rounds = 3;
    result.frames = 300;
    return result;
}

}  // namespace

TEST(Report, SpeedUpsAreMediansOfPairs) {
    const std::vector<EngineSummary> summaries = summarize(worldResult());
    EXPECT_DOUBLE_EQ(summaries[1].part(Part::Frame).speedUp.median, 2);
    EXPECT_DOUBLE_EQ(summaries[1].part(Part::Dynamics).speedUp.upperQuartile, 3);
    EXPECT_DOUBLE_EQ(summaries[0].part(Part::Frame).speedUp.median, 1);
}

TEST(Report, RealTimeFactorIsSimulatedTimeByWallTime) {
    EXPECT_NEAR(summarize(worldResult())[1].realTimeFactor, 300 * 0.01 / 0.6, 1e-12);
}

TEST(Report, TextShowsEnginesSpeedUpsAndHashes) {
    const std::string text = reportText(worldResult());
    EXPECT_NE(text.find("pile:4,sap"), std::string::npos);
    EXPECT_NE(text.find("2.00 [2.00, 3.00]"), std::string::npos) << text;
    EXPECT_NE(text.find("0000000000000abc"), std::string::npos);
    EXPECT_EQ(text.find("WRONG"), std::string::npos);
    EXPECT_EQ(text.find("FAILED"), std::string::npos);
}

// Engines spend 0.1 s of each batch in callbacks.
TEST(Report, TimedCallbacksAreShownApart) {
    EXPECT_EQ(reportText(worldResult()).find("callbacks"), std::string::npos) << "they were not timed";
    EXPECT_EQ(reportCsv({worldResult()}).find("callbacks"), std::string::npos);
    EXPECT_EQ(reportJson({worldResult()}).find("outside_callbacks"), std::string::npos);

    WorldResult result = worldResult();
    for (EngineResult &engine : result.engines)
        for (Batch &batch : engine.batches) batch.seconds.callbacks = 0.1;
    const std::vector<EngineSummary> summaries = summarize(result);
    EXPECT_DOUBLE_EQ(summaries[1].part(Part::Callbacks).speedUp.median, 1);
    EXPECT_DOUBLE_EQ(summaries[1].part(Part::OutsideCallbacks).speedUp.median, 3);
    EXPECT_NE(reportText(result).find("callbacks ms"), std::string::npos);
    EXPECT_NE(reportCsv({result}).find(",callbacks_mean_s,"), std::string::npos);
    EXPECT_NE(reportCsv({result}).find(",outside_callbacks_speedup_median,"), std::string::npos);
    EXPECT_NE(reportJson({result}).find("outside_callbacks"), std::string::npos);
}

TEST(Report, TextShoutsAtAWrongResult) {
    WorldResult result = worldResult();
    result.engines[1].firstDifference = 200;
    const std::string text = reportText(result);
    EXPECT_NE(text.find("DIFFERS"), std::string::npos);
    EXPECT_NE(text.find("WRONG RESULT: ours:2"), std::string::npos);
    EXPECT_NE(text.find("frame 200"), std::string::npos);
}

TEST(Report, TextNamesAFailedEngine) {
    WorldResult result = worldResult();
    result.engines[1] = engineResult("ours:2", {});
    result.engines[1].failure = "killed by signal 11";
    EXPECT_NE(reportText(result).find("FAILED: ours:2: killed by signal 11"), std::string::npos);
}

TEST(Report, TextNamesAFailureOfSeveralEnginesOnce) {
    WorldResult result = worldResult();
    for (EngineResult &engine : result.engines) engine.failure = "world.sdf: /sdf/world/model[m]: not supported";
    const std::string text = reportText(result);
    const std::size_t at = text.find("FAILED: " + summarize(result)[0].engine + ", ours:2: world.sdf: /sdf/world/model[m]: not supported");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_EQ(text.find("FAILED", at + 1), std::string::npos) << text;
}

// Whichever of the engines loaded it.
TEST(Report, TextNamesAWarningOfTheLoaderOnce) {
    WorldResult result = worldResult();
    result.engines[0].failure = "killed by signal 11";
    for (EngineResult &engine : result.engines) engine.ready.warnings = {"world.sdf: left out"};
    const std::string text = reportText(result);
    const std::size_t at = text.find("note: world.sdf: left out\n");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_EQ(text.find("left out", at + 20), std::string::npos) << text;
}

TEST(Report, ThePoolIsMarkedAsNotReproducible) {
    WorldResult result = worldResult();
    result.engines[1].engine = readEngine("stock-pool:2");
    EXPECT_NE(reportText(result).find("not reproducible"), std::string::npos);
}

TEST(Report, TheDirectSolverIsMarkedAsHavingItsOwnBits) {
    WorldResult result = worldResult();
    result.engines[1].engine = readEngine("ours:2/fast");
    EXPECT_NE(reportText(result).find("own bits"), std::string::npos);
}

TEST(Report, EachReleaseHasItsEngines) {
    WorldResult result = worldResult();
    for (EngineResult &engine : result.engines) engine.ready.library = "libode.so.8", engine.ready.release = "0.16.6";
    EXPECT_NE(reportText(result).find("\nODE 0.16.6: stock, ours:2\n\n"), std::string::npos) << reportText(result);
    EXPECT_EQ(reportText(result).find("releases of ODE differ"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(reportJson({result}))["worlds"][0]["engines"][1]["release"], "0.16.6");
    result.engines[0].ready.release = kUnknownRelease;
    EXPECT_NE(reportText(result).find("\na release of ODE that is not known: stock\nODE 0.16.6: ours:2\n\n"), std::string::npos)
        << reportText(result);
    EXPECT_EQ(reportText(result).find("releases of ODE differ"), std::string::npos);
}

TEST(Report, ReleasesThatDifferAreSaidTo) {
    WorldResult result = worldResult();
    result.engines[0].ready.release = "0.16.2";
    result.engines[1].ready.release = "0.16.6";
    const std::string text = reportText(result);
    EXPECT_NE(text.find("note: the releases of ODE differ, so results may"), std::string::npos) << text;
    EXPECT_NE(text.find("other release"), std::string::npos) << text;
    EXPECT_EQ(nlohmann::json::parse(reportJson({result}))["worlds"][0]["engines"][1]["state"], "other release");
    EXPECT_EQ(reportSentence({result}),
              "ODE_MT runs at 2.00 times the speed of libode8 on pile:4,sap (ours:2); the releases of ODE differ, so results may.\n");
}

TEST(Report, JsonHoldsTheFigures) {
    const auto json = nlohmann::json::parse(reportJson({worldResult()}));
    const auto &world = json["worlds"][0];
    EXPECT_EQ(world["world"], "pile:4,sap");
    const auto &ours = world["engines"][1];
    EXPECT_EQ(ours["engine"], "ours:2");
    EXPECT_EQ(ours["state"], "same");
    EXPECT_DOUBLE_EQ(ours["parts"]["frame"]["speedUp"]["median"], 2);
    EXPECT_EQ(ours["parts"]["collision"]["keptAverages"].size(), 3u);
}

TEST(Report, CsvHasOneLineForEachEngineWithAsManyFieldsAsTitles) {
    WorldResult result = worldResult();
    result.world = "pile";
    const std::string csv = reportCsv({result});
    std::istringstream lines(csv);
    std::string header, line;
    std::getline(lines, header);
    int count = 0;
    for (; std::getline(lines, line); ++count)
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(header.begin(), header.end(), ','));
    EXPECT_EQ(count, 2);
}

TEST(Report, JsonHasTheKeptAveragesOnlyIfAskedFor) {
    const auto json = nlohmann::json::parse(reportJson({worldResult()}, false));
    const auto &frame = json["worlds"][0]["engines"][0]["parts"]["frame"];
    EXPECT_TRUE(frame.contains("speedUp"));
    EXPECT_FALSE(frame.contains("keptAverages"));
}

TEST(Report, JsonNamesTheMachine) {
    const auto json = nlohmann::json::parse(reportJson({worldResult()}));
    EXPECT_GE(json["machine"]["cores"], 1);
    EXPECT_TRUE(json["machine"]["processor"].is_string());
}

TEST(Report, JsonHasTheDistributionOfTheSamples) {
    WorldResult result = worldResult();
    result.engines[1] = engineResult("ours:2", {0.5, 1, 0.25});  // 1 and 2 s: 100 frames of 10 ms in each
    const auto json = nlohmann::json::parse(reportJson({result}));
    const auto &samples = json["worlds"][0]["engines"][1]["realTimeSamples"];
    EXPECT_EQ(samples["count"], 2);
    EXPECT_DOUBLE_EQ(samples["mean"], 0.75);
    EXPECT_DOUBLE_EQ(samples["quantiles"]["median"], 0.75);
    EXPECT_DOUBLE_EQ(samples["quantiles"]["percentile5"], 0.5 + 0.05 * 0.5);
}

TEST(Report, OneSentenceSaysHowFastAndWhetherTheSame) {
    WorldResult result = worldResult();
    EXPECT_EQ(reportSentence({result}),
              "ODE_MT runs at 2.00 times the speed of libode8 on pile:4,sap (ours:2), with the same results in every bit.\n");
    EXPECT_EQ(reportSentence({result, result}),
              "ODE_MT runs at 2.00 times the speed of libode8 on pile:4,sap (ours:2), at 2.00 times on pile:4,sap (ours:2), with the same "
              "results in every bit.\n");
    result.engines[1].firstDifference = 100;
    EXPECT_EQ(reportSentence({result}), "");
    result.engines.pop_back();
    EXPECT_EQ(reportSentence({result}), "");
}

TEST(Report, JsonHasTheDistributionOfFrameTimes) {
    WorldResult result = worldResult();
    for (Batch &batch : result.engines[1].batches) batch.frameTimes.add(1e-3);
    result.engines[1].batches[0].frameTimes.add(2e-3);
    const auto json = nlohmann::json::parse(reportJson({result}));
    const auto &times = json["worlds"][0]["engines"][1]["frameTimes"];
    EXPECT_EQ(times["frames"], (std::vector<long>{3, 1}));
    EXPECT_NEAR(times["seconds"][1], 2 * times["seconds"][0].get<double>(), 1e-9);
}

TEST(Report, SamplesAreOneLineForEachSecondOfEachEngine) {
    WorldResult result = worldResult();
    result.engines[0] = engineResult("stock", {2});
    result.engines[1] = engineResult("ours:2", {0.5, 1});
    EXPECT_EQ(reportSamples({result}),
              "world,engine,second,real_time_factor\n"
              "\"pile:4,sap\",stock,1,0.25\n"
              "\"pile:4,sap\",ours:2,1,1\n"
              "\"pile:4,sap\",ours:2,2,0.5\n");
}

TEST(Report, CsvQuotesCommasAndQuotes) {
    WorldResult result = worldResult();
    result.engines[1].failure = "said \"no\"";
    const std::string csv = reportCsv({result});
    EXPECT_NE(csv.find("\"pile:4,sap\""), std::string::npos);
    EXPECT_NE(csv.find("\"said \"\"no\"\"\""), std::string::npos);
}
