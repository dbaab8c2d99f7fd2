// dxHeuristicsManager: names, order, states of all, and changes from inside callbacks.
#include "heuristics/dxHeuristicsManager.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "heuristics/dxHeuristic.h"
#include "heuristics/dxThreadCountHeuristic.h"

namespace {

using Names = std::vector<std::string>;

// Writes its name down at each tick, then does what it was told; says when it is destroyed.
class Probe final : public dxHeuristicBase {
public:
    Probe(std::string name, Names &ticks, std::function<void()> action = {}, bool *destroyed = nullptr)
        : m_name(std::move(name)), m_ticks(ticks), m_action(std::move(action)), m_destroyed(destroyed) {
        start();
    }
    ~Probe() override {
        if (m_destroyed != nullptr) *m_destroyed = true;
    }

private:
    void judge() override {
        m_ticks.push_back(m_name);
        if (m_action) m_action();
    }
    void forget() override {}

    std::string m_name;
    Names &m_ticks;
    std::function<void()> m_action;
    bool *m_destroyed;
};

class HeuristicsManager : public testing::Test {
protected:
    Probe *add(const std::string &name, std::function<void()> action = {}, bool *destroyed = nullptr) {
        return manager.add(name, std::make_unique<Probe>(name, ticks, std::move(action), destroyed));
    }

    Names ticks;
    dxHeuristicsManager manager;
};

TEST_F(HeuristicsManager, EmptyManagerIsFine) {
    EXPECT_TRUE(manager.tick());
    EXPECT_EQ(manager.frames(), 1u);
    EXPECT_EQ(manager.startAll() + manager.pauseAll() + manager.resetAll() + manager.stopAll(), 0u);
    EXPECT_EQ(manager.find("x"), nullptr);
    EXPECT_FALSE(manager.remove("x"));
}

TEST_F(HeuristicsManager, OwnsHeuristicsByName) {
    bool destroyed = false;
    Probe *probe = add("a", {}, &destroyed);
    EXPECT_EQ(manager.find("a"), probe);
    EXPECT_EQ(manager.find("b"), nullptr);
    EXPECT_TRUE(manager.remove("a"));
    EXPECT_TRUE(destroyed);
    EXPECT_EQ(manager.find("a"), nullptr);
    EXPECT_FALSE(manager.remove("a"));
}

TEST_F(HeuristicsManager, DestroysWhatItOwns) {
    bool destroyed = false;
    {
        dxHeuristicsManager other;
        other.add("a", std::make_unique<Probe>("a", ticks, std::function<void()>(), &destroyed));
    }
    EXPECT_TRUE(destroyed);
}

TEST_F(HeuristicsManager, RefusesATakenOrEmptyNameAndNothing) {
    Probe *first = add("a");
    EXPECT_EQ(add("a"), nullptr);
    EXPECT_EQ(add(""), nullptr);
    EXPECT_EQ(manager.add("n", std::unique_ptr<Probe>()), nullptr);
    EXPECT_EQ(manager.find("a"), first);
    EXPECT_EQ(manager.names(), Names{"a"});
}

TEST_F(HeuristicsManager, TicksInTheOrderOfAddition) {
    for (const char *name : {"z", "m", "a"}) add(name);
    manager.tick();
    manager.tick();
    EXPECT_EQ(ticks, (Names{"z", "m", "a", "z", "m", "a"}));
    EXPECT_EQ(manager.names(), (Names{"z", "m", "a"}));
    EXPECT_EQ(manager.frames(), 2u);
}

TEST_F(HeuristicsManager, HoldsHeuristicsOfEveryKind) {
    EXPECT_NE(manager.add("clusters", std::make_unique<dxHeuristic<int>>(0)), nullptr);
    EXPECT_NE(manager.add("load", std::make_unique<dxHeuristic<double>>(0.0)), nullptr);
    EXPECT_NE(manager.add("threads", std::make_unique<dxThreadCountHeuristic>()), nullptr);
    EXPECT_EQ(manager.startAll(), 3u);
    EXPECT_TRUE(manager.tick());
}

TEST_F(HeuristicsManager, ChangesAllThatMayFollow) {
    auto *a = manager.add("a", std::make_unique<dxHeuristic<int>>(0));
    auto *b = manager.add("b", std::make_unique<dxHeuristic<int>>(0));
    EXPECT_EQ(manager.pauseAll(), 0u) << "none runs";
    EXPECT_EQ(manager.startAll(), 2u);
    a->pause();
    EXPECT_EQ(manager.pauseAll(), 1u);
    EXPECT_EQ(manager.startAll(), 2u);
    b->stop();
    EXPECT_EQ(manager.stopAll(), 1u);
    EXPECT_EQ(manager.startAll(), 0u) << "a stopped one needs a reset";
    EXPECT_EQ(manager.resetAll(), 2u);
    EXPECT_EQ(a->state(), dxHeuristicState::Reset);
    EXPECT_EQ(manager.startAll(), 2u);
}

TEST_F(HeuristicsManager, PausedHeuristicsAreNotTicked) {
    add("a");
    add("b")->pause();
    manager.tick();
    EXPECT_EQ(ticks, Names{"a"});
}

TEST_F(HeuristicsManager, AHeuristicRemovedInATickIsDestroyedAfterIt) {
    bool ownGone = false, laterGone = false;
    add(
        "own",
        [&] {
            EXPECT_TRUE(manager.remove("own"));
            EXPECT_TRUE(manager.remove("later"));
            EXPECT_FALSE(manager.remove("later"));
            EXPECT_EQ(manager.find("later"), nullptr);
            EXPECT_FALSE(ownGone || laterGone);
        },
        &ownGone);
    add("later", {}, &laterGone);
    add("last");
    manager.tick();
    EXPECT_TRUE(ownGone && laterGone);
    EXPECT_EQ(ticks, (Names{"own", "last"}));
    EXPECT_EQ(manager.names(), Names{"last"});
}

TEST_F(HeuristicsManager, AHeuristicAddedInATickIsTickedFromTheNextFrameOn) {
    bool done = false;
    add("adder", [&] {
        if (done) return;
        done = true;
        for (int i = 0; i < 50; ++i) EXPECT_NE(add("new" + std::to_string(i)), nullptr);
        EXPECT_TRUE(manager.remove("replaced"));
        EXPECT_NE(add("replaced"), nullptr) << "a name is free once its heuristic was removed";
    });
    add("replaced");
    manager.tick();
    EXPECT_EQ(ticks, Names{"adder"});
    manager.tick();
    EXPECT_EQ(ticks.size(), 1u + 52u);
}

TEST_F(HeuristicsManager, ATickInsideATickIsRefused) {
    add("a", [&] { EXPECT_FALSE(manager.tick()); });
    EXPECT_TRUE(manager.tick());
    EXPECT_EQ(manager.frames(), 1u);
    EXPECT_EQ(ticks, Names{"a"});
}

TEST_F(HeuristicsManager, SurvivesAThrowingCallback) {
    bool thrown = false;
    add("a", [&] {
        if (thrown) return;
        thrown = true;
        manager.remove("b");
        throw std::runtime_error("user code");
    });
    add("b");
    EXPECT_THROW(manager.tick(), std::runtime_error);
    EXPECT_TRUE(manager.tick());
    EXPECT_EQ(ticks, (Names{"a", "a"}));
}

TEST_F(HeuristicsManager, ManyHeuristics) {
    for (int i = 0; i < 1000; ++i) add(std::to_string(i));
    manager.tick();
    ASSERT_EQ(ticks.size(), 1000u);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(ticks[i], std::to_string(i));
}

}  // namespace
