// Runs a scenario in a child process on one of the two libraries.
#pragma once

#include "support/child_run.h"
#include "comparison.h"

#include <optional>
#include <string>
#include <vector>

namespace exactness {

struct ScenarioName {
    std::string name;           // "ball_joints/quick"
    std::string serialBecause;  // see catalogue.h
    std::string callbacks;      // see catalogue.h; empty: one at a time
    std::string largeIsland;           // "team": see Scenario::largeIsland
};

std::vector<ScenarioName> listScenarios();

// The settings of ODE_MT, which are passed in its environment. No algorithm but "auto" and "serial" tests whether parallelism
// out pays, so small scenes test the parallel step too.
struct ThreadSetting {
    std::string manager;  // "pthread" or "openmp"
    int threads;
    bool disturbed = false;  // its schedule is disturbed on purpose
    std::string algorithm = "lcp";
    std::string callbacks = "serial";
    std::string instructionSet = "";  // of vector code; empty: the widest that the machine has
};

// The library and settings that run a scenario.
struct Player {
    std::optional<ThreadSetting> setting;  // of ODE_MT; nothing: Debian's libode8
    bool patternMemory = true;             // fill fresh memory with a pattern
    bool unordered = false;                // record near pairs and contacts without their order
};
const Player libode8{std::nullopt, false};
const Player libode8Again{std::nullopt, true};

std::string libraryFolder(const Player &player);

// One run. Throws std::runtime_error if the child does not come to its end.
Record runScenario(const std::string &scenario, const Player &player);

// Both runs again with all values of the step in which they differ.
std::optional<Difference> nameDifference(const std::string &scenario, const Player &expected,
                                         const Player &actual, int step);

}  // namespace exactness
