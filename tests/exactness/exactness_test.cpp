// Every scenario on ODE_MT with every number of threads, every thread manager and vectors of every width, against
// Debian's libode8 on one thread (contract C2).
#include "instruction_set.h"
#include "scenario_run.h"
#include "thorough.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>

namespace {

using namespace exactness;

// Every other number of threads runs under a schedule that is disturbed on purpose: 2 with each scenario, 5 and 16 with every other one, as a
// disturbed run takes three times as long.
struct Threads {
    int count;
    bool disturbed;
};
constexpr Threads threadCounts[] = {{0, false}, {1, false}, {2, true}, {3, false},
                                    {5, true},  {8, false}, {16, true}};
constexpr Threads threadCountsOfOpenmp[] = {{3, false}, {5, true}, {8, false}, {16, true}};
constexpr const char *managers[] = {"pthread", "openmp"};

constexpr Threads fewerThreadCounts[] = {{0, false}, {1, false}, {2, true}, {3, false}, {8, false}};
constexpr const char *algorithms[] = {"auto",   "serial",          "lcp",         "original",
                                      "static", "static-unmerged", "duplication", "decluster"};

// libode8's run of the scenario that was asked for last.
const Record &stockRecord(const std::string &scenario, bool unordered) {
    static std::string cachedFor;
    static Record cached;
    const std::string key = scenario + (unordered ? " unordered" : "");
    if (cachedFor != key) {
        Player stock = libode8;
        stock.unordered = unordered;
        cached = runScenario(scenario, stock);
        cachedFor = key;
    }
    return cached;
}

class ExactnessTest : public testing::Test {
public:
    ExactnessTest(ScenarioName scenario, Player player) : m_scenario(scenario), m_player(player) {}

    void TestBody() override {
        const Record &expected = stockRecord(m_scenario.name, m_player.unordered);
        std::string notShared;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            const Record actual = runScenario(m_scenario.name, m_player);
            checkEngines(expected.engine, actual.engine);
            checkEqual(expected, actual);
            notShared = notSharedOut(actual.engine);
            if (HasFailure() || notShared.empty()) break;
        }
        EXPECT_EQ(notShared, "");
    }

private:
    // A comparison of a library with itself would always succeed, and so might one of vectors that were not taken.
    void checkEngines(const Engine &expected, const Engine &actual) const {
        EXPECT_FALSE(expected.isOdeMt) << expected.library;
        EXPECT_EQ(expected.library.rfind(libraryFolder(libode8), 0), 0u) << expected.library;
        EXPECT_EQ(actual.isOdeMt, m_player.setting.has_value()) << actual.library;
        if (!m_player.setting || m_player.setting->instructionSet.empty()) return;
        EXPECT_EQ(actual.instructionSet, m_player.setting->instructionSet);
    }

    void checkEqual(const Record &expected, const Record &actual) const {
        const auto divergence = firstDivergence(expected, actual);
        if (!divergence) return;
        Player stock = libode8;
        stock.unordered = m_player.unordered;
        const auto difference = nameDifference(m_scenario.name, stock, m_player, divergence->step);
        ADD_FAILURE() << m_scenario.name << " first differs in step " << divergence->step << ", stage '"
                      << divergence->stage << "'\n"
                      << (difference ? difference->describe()
                                     : "but not when run again: the difference does not repeat");
    }

    // Returns what should have run in parallel and did not; empty if nothing is missing. On a busy machine a second worker may never
    // come in time, so this is asked only where the schedule is disturbed, and of one attempt in several.
    std::string notSharedOut(const Engine &engine) const {
        if (!m_player.setting || m_player.setting->threads < 2 || !m_scenario.serialBecause.empty()) return "";
        const std::string &algorithm = m_player.setting->algorithm;
        if (algorithm == "auto" || algorithm == "serial") return "";
        const bool largeIsland = m_scenario.largeIsland == "team";
        if (!largeIsland && engine.parallelSteps + engine.teamSteps == 0) return "no step ran in parallel";
        if (!m_player.setting->disturbed) return "";
        if (largeIsland && engine.teamSteps == 0) return "no two workers stepped the island";
        if (engine.maxWorkers < 2) return "no second worker stepped an island";
        // Clusters may be one.
        const bool shares =
            m_player.setting->callbacks != "serial" && m_scenario.callbacks == "shared" && algorithm == "lcp";
        return shares && engine.parallelCollisions == 0 ? "no second worker ran callbacks" : "";
    }

    static constexpr int kAttempts = 5;

    ScenarioName m_scenario;
    Player m_player;
};

// Whether it is the turn of this player, too, by ODE_MT_EXACTNESS. Scenarios do not begin with the same one. That without threads, which takes the
// least time, has no turns.
bool isItsTurn(const ScenarioName &scenario, const Player &player) {
    static std::string last;
    static std::size_t scenarios = 0, players = 0;
    if (last != scenario.name) {
        last = scenario.name;
        players = scenarios++;
    }
    const ThreadSetting without{managers[0], 0};
    const bool isWithout = player.setting && player.setting->threads == 0 && player.setting->algorithm == without.algorithm &&
                           player.setting->instructionSet == without.instructionSet;
    return isWithout || isTurnOfCase(players++);
}

void addTest(const ScenarioName &scenario, const std::string &name, const Player &player) {
    if (!isItsTurn(scenario, player)) return;
    testing::RegisterTest(("Exactness/" + scenario.name).c_str(), name.c_str(), nullptr, nullptr, __FILE__,
                          __LINE__, [=]() -> testing::Test * { return new ExactnessTest(scenario, player); });
}

// If the cycle selects this combination: serial callbacks and, where the scenario allows them, concurrent ones. With "lcp"
// and two threads they are always concurrent, too. Alternately they share bodies.
void addAlgorithmTests(const ScenarioName &scenario, const char *algorithm, const Threads &threads, bool isItsTurn) {
    std::string name = std::string(algorithm) + '_' + std::to_string(threads.count);
    Player player{ThreadSetting{managers[0], threads.count, threads.disturbed, algorithm}};
    const bool isLcp = algorithm == std::string("lcp"), isAlwaysConcurrent = isLcp && threads.count == 2;
    if (isItsTurn && !isLcp) addTest(scenario, name, player);
    if (scenario.callbacks.empty() || !(isItsTurn || isAlwaysConcurrent)) return;
    player.unordered = true;
    const auto addPolicy = [&](const char *policy) {
        player.setting->callbacks = policy;
        addTest(scenario, name + '_' + policy, player);
    };
    const bool mayShareBodies = threads.count % 2 != 0;
    if (isLcp || !mayShareBodies) addPolicy("concurrent");
    if (isItsTurn && (isLcp || mayShareBodies)) addPolicy("independent");
}

// Vector code runs with the widest vectors otherwise.
void addInstructionSetTest(const ScenarioName &scenario, const std::string &set, const Threads &threads) {
    ThreadSetting setting{managers[0], threads.count, threads.disturbed};
    setting.instructionSet = set;
    addTest(scenario, set + '_' + std::to_string(threads.count), Player{setting});
}

void addManagerTest(const ScenarioName &scenario, const char *manager, const Threads &threads) {
    addTest(scenario, manager + ('_' + std::to_string(threads.count)), Player{ThreadSetting{manager, threads.count, threads.disturbed}});
}

// Scenarios take every third algorithm and instruction set with one number of threads, and OpenMP with one or two, cyclically, so that all of them
// together have every combination many times. ODE_MT_EXACTNESS=thorough: each has every one.
void addTests(const ScenarioName &scenario) {
    static std::size_t turn = 0;
    static const std::vector<std::string> sets = instructionSets();
    const auto isTurnOf = [](std::size_t place, std::size_t threads) {
        return isThorough() || threads == (turn + place) % (3 * std::size(fewerThreadCounts));
    };
    // Is the scenario itself repeatable? If it is not, the other tests fail too.
    if (isThorough()) addTest(scenario, "libode8_again", libode8Again);
    for (Threads threads : threadCounts) {
        const bool isLarge = threads.count > 2, isTurnOfThis = turn % 2 == (threads.count == 16 ? 1 : 0);
        threads.disturbed = threads.disturbed && (!isLarge || isTurnOfThis || isThorough());
        addManagerTest(scenario, managers[0], threads);
    }
    // Below two threads no manager has anything to do: pthread stands for both.
    if (isThorough() || turn % 2 == 0) addManagerTest(scenario, managers[1], {2, true});
    for (std::size_t t = 0; t < std::size(threadCountsOfOpenmp); ++t)
        if (isThorough() || turn % std::size(threadCountsOfOpenmp) == t) addManagerTest(scenario, managers[1], threadCountsOfOpenmp[t]);
    for (std::size_t a = 0; a < std::size(algorithms); ++a)
        for (std::size_t t = 0; t < std::size(fewerThreadCounts); ++t)
            addAlgorithmTests(scenario, algorithms[a], fewerThreadCounts[t], isTurnOf(a, t));
    for (std::size_t s = 1; s < sets.size(); ++s)
        for (std::size_t t = 0; t < std::size(fewerThreadCounts); ++t)
            if (isTurnOf(s, t)) addInstructionSetTest(scenario, sets[s], fewerThreadCounts[t]);
    ++turn;
}

}  // namespace

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    for (const ScenarioName &scenario : listScenarios()) addTests(scenario);
    return RUN_ALL_TESTS();
}
