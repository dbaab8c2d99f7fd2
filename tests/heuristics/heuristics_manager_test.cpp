// dxHeuristicsManager: owns, and ticks in order.
#include "clusters/heuristics/dxHeuristicsManager.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace {

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

TEST_F(HeuristicsManager, EmptyManagerIsFine) { manager.tick(); }

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

}  // namespace
