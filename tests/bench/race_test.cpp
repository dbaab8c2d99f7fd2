#include "race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using namespace bench;

namespace {

// Follows a script instead of simulating: fixed time for a frame, a state that counts its frames.
class Actor final : public Competitor {
public:
    Actor(const std::string &engine, double secondsPerFrame, std::vector<std::string> &log)
        : Competitor(readEngine(engine)), m_secondsPerFrame(secondsPerFrame), m_log(log) {}

    Ready start() override {
        if (failsAtStart) throw std::runtime_error("world 'x' has no floor");
        Ready ready;
        ready.release = release;
        return ready;
    }

    Batch run(int frames) override {
        m_frames += frames;
        m_log.push_back(engine().name());
        if (m_frames > failsAfter) throw std::runtime_error("killed by signal 11");
        Batch batch;
        batch.frames = frames;
        batch.seconds.step = frames * m_secondsPerFrame;
        batch.hash = static_cast<std::uint64_t>(m_frames) + (m_frames > differsAfter ? 1 : 0);
        return batch;
    }

    bool failsAtStart = false;
    std::string release = kUnknownRelease;
    long failsAfter = 1'000'000'000, differsAfter = 1'000'000'000;

private:
    double m_secondsPerFrame;
    std::vector<std::string> &m_log;
    long m_frames = 0;
};

class RaceTest : public testing::Test {
protected:
    Actor &add(const std::string &engine, double secondsPerFrame) {
        auto actor = std::make_unique<Actor>(engine, secondsPerFrame, log);
        Actor &result = *actor;
        competitors.push_back(std::move(actor));
        return result;
    }

    WorldResult run() {
        return race("x", competitors, settings, [this](const WorldResult &) { ++roundsSeen; });
    }

    std::vector<std::string> log;
    Competitors competitors;
    RaceSettings settings;
    int roundsSeen = 0;
};

}  // namespace

TEST_F(RaceTest, EnginesTakeTurnsInRotatingOrder) {
    add("stock", 5e-3);
    add("ours:1", 5e-3);
    settings.warmUpFrames = 1;
    settings.stop.maximumFrames = 30;  // three batches of ten
    run();
    const std::vector<std::string> warmUp = {"stock", "ours:1"};
    const std::vector<std::string> rounds = {"stock", "ours:1", "ours:1", "stock", "stock", "ours:1"};
    ASSERT_EQ(log.size(), warmUp.size() + rounds.size());
    EXPECT_TRUE(std::equal(warmUp.begin(), warmUp.end(), log.begin()));
    EXPECT_TRUE(std::equal(rounds.begin(), rounds.end(), log.begin() + 2));
}

TEST_F(RaceTest, WithoutWarmUpTheFirstBatchIsOneFrame) {
    Actor &stock = add("stock", 5e-3);
    stock.failsAfter = 1;
    settings.warmUpFrames = 0;
    const WorldResult result = run();
    ASSERT_EQ(result.engines[0].batches.size(), 1u);
    EXPECT_EQ(result.engines[0].batches[0].frames, 1);
}

TEST_F(RaceTest, AllEnginesRunTheSameFramesAfterTheSameWarmUp) {
    add("stock", 5e-3);
    add("ours:1", 7e-3);
    settings.stop.maximumFrames = 123;
    const WorldResult result = run();
    EXPECT_EQ(result.warmUpFrames, 100);
    EXPECT_EQ(result.frames, 123);
    for (const EngineResult &engine : result.engines) EXPECT_EQ(engine.batches.back().hash, 223u);
    EXPECT_TRUE(result.isClean());
    EXPECT_EQ(roundsSeen, result.rounds);
}

// Another release of ODE may have other bits; engines of one release may not.
TEST_F(RaceTest, StatesAreComparedWithinEachRelease) {
    add("stock", 5e-3).release = "0.16.2";
    Actor &other = add("stock:/other", 5e-3), &ours = add("ours:1", 5e-3);
    other.release = ours.release = "0.16.6";
    other.differsAfter = ours.differsAfter = 50;
    settings.stop.maximumFrames = 123;
    WorldResult result = run();
    EXPECT_TRUE(result.isClean());
    EXPECT_TRUE(result.hasSeveralReleases());
    EXPECT_EQ(result.engines[2].firstDifference, -1);
}

TEST_F(RaceTest, AStateThatDiffersWithinAReleaseIsWrong) {
    add("stock", 5e-3).release = "0.16.2";
    add("stock:/other", 5e-3).release = "0.16.6";
    Actor &ours = add("ours:1", 5e-3);
    ours.release = "0.16.6";
    ours.differsAfter = 50;
    const WorldResult result = run();
    EXPECT_FALSE(result.isClean());
    EXPECT_GE(result.engines[2].firstDifference, 50);
    EXPECT_EQ(result.engines[1].firstDifference, -1);
}

TEST_F(RaceTest, AnUnknownReleaseIsComparedWithAll) {
    add("stock:/mine", 5e-3);
    Actor &ours = add("ours:1", 5e-3);
    ours.release = "0.16.6";
    ours.differsAfter = 50;
    const WorldResult result = run();
    EXPECT_FALSE(result.isClean());
    EXPECT_FALSE(result.hasSeveralReleases());
}

TEST_F(RaceTest, TheWarmUpOfAHeavyWorldIsShort) {
    add("stock", 0.6);
    settings.stop.maximumFrames = 1;
    EXPECT_LT(run().warmUpFrames, 5);
}

TEST_F(RaceTest, StopsWhenStable) {
    add("stock", 5e-3);
    add("ours:1", 2e-3);
    const WorldResult result = run();
    EXPECT_EQ(result.verdict, StoppingRule::Verdict::Stable);
    EXPECT_GE(result.rounds, settings.stop.minimumRounds);
}

TEST_F(RaceTest, StopsWhenTimeIsUp) {
    add("stock", 0.3);
    settings.stop.maximumSeconds = 4;
    EXPECT_EQ(run().verdict, StoppingRule::Verdict::OutOfTime);
}

TEST_F(RaceTest, ADifferentStateIsFoundInItsRound) {
    add("stock", 5e-3);
    add("ours:1", 5e-3);
    add("ours:2", 5e-3).differsAfter = 115;
    settings.stop.maximumFrames = 50;
    const WorldResult result = run();
    EXPECT_FALSE(result.isClean());
    EXPECT_EQ(result.engines[1].firstDifference, -1);
    EXPECT_EQ(result.engines[2].firstDifference, 120);
}

TEST_F(RaceTest, TheStockPoolMayDiffer) {
    add("stock", 5e-3);
    add("stock-pool:2", 5e-3).differsAfter = 0;
    settings.stop.maximumFrames = 50;
    EXPECT_TRUE(run().isClean());
}

TEST_F(RaceTest, AnEngineThatFailsIsNamedAndTheOthersGoOn) {
    add("stock", 5e-3);
    add("ours:1", 5e-3).failsAfter = 115;
    add("ours:2", 5e-3);
    settings.stop.maximumFrames = 50;
    const WorldResult result = run();
    EXPECT_FALSE(result.isClean());
    EXPECT_EQ(result.engines[1].failure, "killed by signal 11");
    EXPECT_EQ(result.engines[1].batches.size(), 1u);
    EXPECT_EQ(result.engines[2].batches.size(), 5u);
    EXPECT_EQ(result.frames, 50);
}

TEST_F(RaceTest, TheFirstEngineMayFailAtTheStart) {
    add("stock", 5e-3).failsAtStart = true;
    add("ours:1", 5e-3);
    settings.stop.maximumFrames = 50;
    const WorldResult result = run();
    EXPECT_EQ(result.engines[0].failure, "world 'x' has no floor");
    EXPECT_EQ(result.engines[1].batches.size(), 5u);
}

TEST_F(RaceTest, EndsWhenAllHaveFailed) {
    add("stock", 5e-3).failsAtStart = true;
    add("ours:1", 5e-3).failsAfter = 105;
    const WorldResult result = run();
    EXPECT_FALSE(result.isClean());
    EXPECT_EQ(result.rounds, 1);
}
