// Order of alerts, and what callbacks may do to the alerts and their heuristic.
#include "heuristics/dxHeuristicAlertList.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "AlertLog.h"

namespace {

using Alert = dxHeuristicAlert;
using Frames = std::vector<std::uint64_t>;

// A callback made of a function.
struct Call : HeuristicAlertCallback<double> {
    using Function = std::function<void(dxHeuristic<double> &, const Alert &)>;
    explicit Call(Function f) : function(std::move(f)) {}
    void alertCallback(dxHeuristic<double> &heuristic, const Alert &alert) override {
        function(heuristic, alert);
    }
    Function function;
};

TEST(HeuristicAlertList, ACallbackLearnsWhichAlertItWas) {
    dxHeuristic<double> heuristic(0);
    Call call([&](dxHeuristic<double> &which, const Alert &alert) {
        EXPECT_EQ(&which, &heuristic);
        EXPECT_EQ(alert.kind(), Alert::Kind::ValueAbove);
        EXPECT_EQ(alert.threshold(), 3);
    });
    heuristic.addAlert(Alert::valueAbove(3), call);
    heuristic.start();
    run(heuristic, {4});
    EXPECT_EQ(Alert::everyFrames(8).interval(), 8u);
}

TEST(HeuristicAlertList, ThousandsComeInTheOrderOfAddition) {
    constexpr unsigned kAlerts = 5000;
    dxHeuristic<double> heuristic(0);
    std::vector<unsigned> order;
    std::vector<std::unique_ptr<Call>> calls;
    for (unsigned i = 0; i < kAlerts; ++i) {
        calls.push_back(std::make_unique<Call>([&order, i](auto &, const Alert &) { order.push_back(i); }));
        heuristic.addAlert(i % 2 == 0 ? Alert::everyFrames(1) : Alert::valueAbove(-1), *calls.back());
    }
    heuristic.start();
    run(heuristic, {0});
    ASSERT_EQ(order.size(), kAlerts);
    for (unsigned i = 0; i < kAlerts; ++i) ASSERT_EQ(order[i], i);
}

TEST(HeuristicAlertList, RemovedAlertsAreGone) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> first, second;
    const dxAlertId a = heuristic.addAlert(Alert::everyFrames(1), first);
    const dxAlertId b = heuristic.addAlert(Alert::everyFrames(1), second);
    EXPECT_NE(a, b);
    EXPECT_TRUE(heuristic.removeAlert(a));
    EXPECT_FALSE(heuristic.removeAlert(a));
    EXPECT_FALSE(heuristic.removeAlert(0));
    EXPECT_FALSE(heuristic.removeAlert(b + 1));
    heuristic.start();
    run(heuristic, {0});
    EXPECT_EQ(first.frames, Frames{});
    EXPECT_EQ(second.frames, Frames{1});
    EXPECT_GT(heuristic.addAlert(Alert::everyFrames(1), first), b) << "numbers are not used twice";
}

TEST(HeuristicAlertList, AnAlertAddedInACallbackComesFromTheNextFrameOn) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> added;
    Call adder([&](auto &h, const Alert &) {
        for (int i = 0; i < 100; ++i) h.addAlert(Alert::everyFrames(1), added);  // the list moves in memory
    });
    heuristic.addAlert(Alert::everyFrames(2), adder);
    heuristic.start();
    run(heuristic, {0, 0});
    EXPECT_EQ(added.frames, Frames{});
    EXPECT_EQ(heuristic.alerts(), 101u);
    run(heuristic, {0});
    EXPECT_EQ(added.frames, Frames(100, 3));
}

TEST(HeuristicAlertList, AnAlertRemovedInACallbackDoesNotComeAnyMore) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> before, after;
    dxAlertId own = 0, earlier = 0, later = 0;
    Call remover([&](auto &h, const Alert &) {
        EXPECT_TRUE(h.removeAlert(earlier));
        EXPECT_TRUE(h.removeAlert(own));
        EXPECT_TRUE(h.removeAlert(later));
        EXPECT_FALSE(h.removeAlert(later)) << "it is gone at once";
        EXPECT_EQ(h.alerts(), 0u);
    });
    earlier = heuristic.addAlert(Alert::everyFrames(1), before);
    own = heuristic.addAlert(Alert::everyFrames(1), remover);
    later = heuristic.addAlert(Alert::everyFrames(1), after);
    heuristic.start();
    run(heuristic, {0, 0});
    EXPECT_EQ(before.frames, Frames{1});
    EXPECT_EQ(after.frames, Frames{});
}

TEST(HeuristicAlertList, WhatACallbackDoesToTheHeuristicTakesNoAlertFromTheOthers) {
    for (const auto change : {&dxHeuristicBase::pause, &dxHeuristicBase::stop, &dxHeuristicBase::reset}) {
        dxHeuristic<double> heuristic(0);
        unsigned others = 0;
        Call changer([&](auto &h, const Alert &) { EXPECT_TRUE((h.*change)()); });
        Call other([&](auto &, const Alert &) { ++others; });
        heuristic.addAlert(Alert::everyFrames(1), changer);
        heuristic.addAlert(Alert::everyFrames(1), other);
        heuristic.start();
        run(heuristic, {1, 1});
        EXPECT_EQ(others, 1u) << "this frame's, and no more";
    }
}

TEST(HeuristicAlertList, ATickInsideACallbackIsRefused) {
    dxHeuristic<double> heuristic(0);
    Call call([](auto &h, const Alert &) { EXPECT_FALSE(h.tick()); });
    heuristic.addAlert(Alert::everyFrames(1), call);
    heuristic.start();
    EXPECT_TRUE(heuristic.tick());
    EXPECT_EQ(heuristic.samples(), 1u);
}

TEST(HeuristicAlertList, AThrowingCallbackLeavesTheHeuristicUsable) {
    dxHeuristic<double> heuristic(0);
    AlertLog<double> log;
    dxAlertId thrower = 0;
    Call call([&](auto &h, const Alert &) {
        h.removeAlert(thrower);
        throw std::runtime_error("user code");
    });
    thrower = heuristic.addAlert(Alert::everyFrames(1), call);
    heuristic.addAlert(Alert::everyFrames(1), log);
    heuristic.start();
    EXPECT_THROW(heuristic.tick(), std::runtime_error);
    EXPECT_TRUE(heuristic.tick());
    EXPECT_EQ(log.frames, Frames{2});
    EXPECT_EQ(heuristic.alerts(), 1u);
}

}  // namespace
