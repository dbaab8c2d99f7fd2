// dxHeuristic: which state may follow which, in the table and in a heuristic that is driven through all of them; which changes of its parameter
// it reports. dxHeuristicsManager: owns heuristics, and ticks them in order. The median.
#include "clusters/heuristics/dxHeuristic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "AlertLog.h"

namespace {

using State = dxHeuristicState;

// Counts the frames that it judges.
class Counter final : public dxHeuristic {
public:
    unsigned judged = 0;

private:
    void judge() override { ++judged; }
    void forget() override { judged = 0; }
};

constexpr State kStates[] = {State::Init, State::Reset, State::Running, State::Paused, State::Stopped};

const std::set<std::pair<State, State>> kLegal = {
    {State::Init, State::Reset},    {State::Init, State::Running},   {State::Init, State::Stopped},
    {State::Reset, State::Reset},   {State::Reset, State::Running},  {State::Reset, State::Stopped},
    {State::Running, State::Reset}, {State::Running, State::Paused}, {State::Running, State::Stopped},
    {State::Paused, State::Reset},  {State::Paused, State::Running}, {State::Paused, State::Stopped},
    {State::Stopped, State::Reset},
};

const char *nameOf(State state) {
    constexpr const char *kNames[] = {"init", "reset", "running", "paused", "stopped"};
    return kNames[static_cast<int>(state)];
}

// A heuristic brought to the state by legal ways.
std::unique_ptr<Counter> heuristicIn(State state) {
    auto heuristic = std::make_unique<Counter>();
    if (state == State::Reset) heuristic->reset();
    if (state == State::Running || state == State::Paused || state == State::Stopped) heuristic->start();
    if (state == State::Paused) heuristic->pause();
    if (state == State::Stopped) heuristic->stop();
    return heuristic;
}

bool change(Counter &heuristic, State to) {
    switch (to) {
        case State::Reset:
            return heuristic.reset();
        case State::Running:
            return heuristic.start();
        case State::Paused:
            return heuristic.pause();
        case State::Stopped:
            return heuristic.stop();
        case State::Init:
            break;
    }
    return false;
}

TEST(HeuristicState, TheTableHoldsExactlyTheLegalChanges) {
    for (const State from : kStates) {
        for (const State to : kStates) {
            EXPECT_EQ(dxMayFollow(from, to), kLegal.count({from, to}) == 1)
                << nameOf(from) << " to " << nameOf(to);
        }
    }
}

TEST(HeuristicState, AHeuristicFollowsTheTableAndARefusedChangeChangesNothing) {
    for (const State from : kStates) {
        for (const State to : kStates) {
            const auto heuristic = heuristicIn(from);
            ASSERT_EQ(heuristic->state(), from);
            const bool legal = kLegal.count({from, to}) == 1;
            EXPECT_EQ(change(*heuristic, to), legal) << nameOf(from) << " to " << nameOf(to);
            EXPECT_EQ(heuristic->state(), legal ? to : from);
        }
    }
}

TEST(HeuristicState, OnlyARunningHeuristicTicks) {
    for (const State state : kStates) {
        const auto heuristic = heuristicIn(state);
        EXPECT_EQ(heuristic->tick(), state == State::Running) << nameOf(state);
        EXPECT_EQ(heuristic->judged, state == State::Running ? 1u : 0u) << nameOf(state);
    }
}

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

TEST(Heuristic, NotifiesOfEachChangeOnce) {
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

TEST(Heuristic, DoesNotNotifyWhileItDoesNotRun) {
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

TEST(Heuristic, NeedsNoCallback) {
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

using Names = std::vector<std::string>;

// Writes its name down at each tick; says when it is destroyed.
class Probe final : public dxHeuristic {
public:
    Probe(std::string name, Names &ticks, bool *destroyed = nullptr)
        : m_name(std::move(name)), m_ticks(ticks), m_destroyed(destroyed) {
        start();
    }
    ~Probe() override {
        if (m_destroyed != nullptr) *m_destroyed = true;
    }

private:
    void judge() override { m_ticks.push_back(m_name); }
    void forget() override {}

    std::string m_name;
    Names &m_ticks;
    bool *m_destroyed;
};

class HeuristicsManager : public testing::Test {
protected:
    Probe *add(const std::string &name) { return manager.add(std::make_unique<Probe>(name, ticks)); }

    Names ticks;
    dxHeuristicsManager manager;
};

TEST_F(HeuristicsManager, MayBeEmpty) { manager.tick(); }

TEST_F(HeuristicsManager, DestroysWhatItOwns) {
    bool destroyed = false;
    {
        dxHeuristicsManager other;
        other.add(std::make_unique<Probe>("a", ticks, &destroyed));
        EXPECT_FALSE(destroyed);
    }
    EXPECT_TRUE(destroyed);
}

TEST_F(HeuristicsManager, TicksInTheOrderOfAddition) {
    for (const char *name : {"z", "m", "a"}) add(name);
    manager.tick();
    manager.tick();
    EXPECT_EQ(ticks, (Names{"z", "m", "a", "z", "m", "a"}));
}

TEST_F(HeuristicsManager, PausedHeuristicsAreNotTicked) {
    add("a");
    add("b")->pause();
    manager.tick();
    EXPECT_EQ(ticks, Names{"a"});
}

double medianOf(std::vector<double> numbers) { return dxMedian(numbers); }

TEST(Median, IsTheMiddleOneTheLowerOfTwo) {
    EXPECT_EQ(medianOf({}), 0);
    EXPECT_EQ(medianOf({4}), 4);
    EXPECT_EQ(medianOf({9, 1}), 1);
    EXPECT_EQ(medianOf({9, 1, 5}), 5);
    EXPECT_EQ(medianOf({4, 3, 2, 1}), 2);
    EXPECT_EQ(medianOf({1, std::numeric_limits<double>::infinity(), 2}), 2);
}

TEST(Median, AgreesWithSorting) {
    std::mt19937 random(1);
    for (std::size_t n = 1; n < 60; ++n) {
        std::vector<double> numbers(n);
        for (double &number : numbers) number = random() % 20;
        std::vector<double> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(dxMedian(numbers), sorted[(n - 1) / 2]);
        EXPECT_TRUE(std::is_permutation(numbers.begin(), numbers.end(), sorted.begin()));
    }
}

}  // namespace
