// Which state may follow which, in the table and in a heuristic that is driven through all of them.
#include "clusters/heuristics/dxHeuristic.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "clusters/heuristics/dxHeuristic.h"

namespace {

using State = dxHeuristicState;

// Counts the frames that it judges.
class Heuristic final : public dxHeuristic {
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
std::unique_ptr<Heuristic> heuristicIn(State state) {
    auto heuristic = std::make_unique<Heuristic>();
    if (state == State::Reset) heuristic->reset();
    if (state == State::Running || state == State::Paused || state == State::Stopped) heuristic->start();
    if (state == State::Paused) heuristic->pause();
    if (state == State::Stopped) heuristic->stop();
    return heuristic;
}

bool change(Heuristic &heuristic, State to) {
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

}  // namespace
