// dxHeuristic: whom it tells that its parameter has changed, and when.
#include "clusters/heuristics/dxHeuristic.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "AlertLog.h"

namespace {

// Its parameter is whatever it is given, from the next tick on.
class Follower final : public dxHeuristic {
public:
    double given = 0, parameter = 0;

private:
    void judge() override {
        const double before = parameter;
        parameter = given;
        alert(before, parameter);
    }
    void forget() override { parameter = 0; }
};

TEST(Heuristic, TellsOfEachChangeOnce) {
    AlertLog log;
    Follower heuristic;
    heuristic.setAlertCallback(&log);
    heuristic.start();
    for (const double number : {0, 5, 5, 7, 5}) {
        heuristic.given = number;
        heuristic.tick();
    }
    EXPECT_EQ(log.numbers, (std::vector<double>{5, 7, 5}));
}

TEST(Heuristic, TellsNobodyWhileItDoesNotRun) {
    AlertLog log;
    Follower heuristic;
    heuristic.setAlertCallback(&log);
    heuristic.given = 5;
    EXPECT_FALSE(heuristic.tick());
    heuristic.start();
    heuristic.pause();
    EXPECT_FALSE(heuristic.tick());
    EXPECT_TRUE(log.numbers.empty());
}

TEST(Heuristic, NeedsNobodyToTell) {
    AlertLog log;
    Follower heuristic;
    heuristic.start();
    heuristic.given = 5;
    EXPECT_TRUE(heuristic.tick());
    heuristic.setAlertCallback(&log);
    heuristic.setAlertCallback(nullptr);
    heuristic.given = 6;
    EXPECT_TRUE(heuristic.tick());
    EXPECT_EQ(heuristic.parameter, 6);
    EXPECT_TRUE(log.numbers.empty());
}

TEST(Heuristic, SurvivesACallbackThatThrows) {
    struct Throws final : HeuristicAlertCallback {
        void alertCallback(const dxHeuristic &, const dxHeuristicAlert &) override { throw std::runtime_error("user code"); }
    } callback;
    Follower heuristic;
    heuristic.setAlertCallback(&callback);
    heuristic.start();
    heuristic.given = 5;
    EXPECT_THROW(heuristic.tick(), std::runtime_error);
    EXPECT_TRUE(heuristic.tick()) << "nothing has changed since";
    EXPECT_EQ(heuristic.parameter, 5);
}

}  // namespace
