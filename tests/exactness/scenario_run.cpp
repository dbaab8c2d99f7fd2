#include "scenario_run.h"

#include "thorough.h"
#include "support/temporary_folder.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace exactness {

namespace {

// glibc fills memory with this (malloc) and its complement (free), so that nothing can come out equal
// by the luck of fresh pages being zero.
constexpr const char *memoryPattern = "165";

constexpr int timeLimit = 120;  // s for one child; the slowest takes about one, under ThreadSanitizer twenty

std::string fromEnvironment(const char *variable, const char *otherwise) {
    const char *value = std::getenv(variable);
    return value == nullptr ? otherwise : value;
}

std::string childProgram() { return fromEnvironment("ODE_MT_SCENARIO_PROGRAM", ODE_MT_SCENARIO_PROGRAM); }

std::map<std::string, std::string> variablesFor(const Player &player) {
    std::map<std::string, std::string> variables{{"LD_LIBRARY_PATH", libraryFolder(player)}};
    if (player.patternMemory) variables["MALLOC_PERTURB_"] = memoryPattern;
    if (!player.setting) return variables;
    variables["ODE_MT_THREADS"] = std::to_string(player.setting->threads);
    variables["ODE_MT_THREAD_MANAGER"] = player.setting->manager;
    variables["ODE_MT_ALGORITHM"] = player.setting->algorithm;
    variables["ODE_MT_CALLBACKS"] = player.setting->callbacks;
    // libgomp's teams otherwise spin for 7 ms after each run, on processors that other tests want.
    if (player.setting->manager == "openmp" && !isThorough()) variables["OMP_WAIT_POLICY"] = "passive";
    if (player.setting->disturbed) variables["ODE_MT_PERTURB"] = std::to_string(player.setting->threads);
    return variables;
}

// The end of what a child said, where a crash or a sanitizer speaks.
std::string lastOf(const std::string &text) {
    constexpr std::size_t most = 8000;
    return text.size() <= most ? text : "..." + text.substr(text.size() - most);
}

std::string describe(const Player &player) {
    if (!player.setting) return "libode8";
    return "ODE_MT with " + std::to_string(player.setting->threads) + " threads of " +
           player.setting->manager + ", algorithm " + player.setting->algorithm +
           ", " + player.setting->callbacks + " callbacks" +
           (player.setting->disturbed ? ", disturbed" : "") +
           (player.setting->instructionSet.empty() ? "" : ", vectors of " + player.setting->instructionSet);
}

Record run(const std::string &scenario, const Player &player, const std::vector<std::string> &options) {
    const support::TemporaryFolder folder;
    const std::string path = folder.file("record.json");
    std::vector<std::string> command{childProgram(), scenario,       "--record",
                                     path,           "--time-limit", std::to_string(timeLimit)};
    if (player.unordered) command.push_back("--unordered");
    if (player.setting && !player.setting->instructionSet.empty()) {
        command.insert(command.end(), {"--instruction-set", player.setting->instructionSet});
    }
    command.insert(command.end(), options.begin(), options.end());
    const support::Ending child = support::runProgram(command, variablesFor(player));
    if (!child.exitedWith(0)) {
        throw std::runtime_error(scenario + " on " + describe(player) + " ended with " + child.text() +
                                 ":\n" + lastOf(child.errors));
    }
    return Record::read(path);
}

}  // namespace

std::string libraryFolder(const Player &player) {
    return player.setting ? fromEnvironment("ODE_MT_LIBRARY_DIR", ODE_MT_LIBRARY_DIR)
                          : fromEnvironment("ODE_MT_STOCK_LIBRARY_DIR", ODE_MT_STOCK_LIBRARY_DIR);
}

std::vector<ScenarioName> listScenarios() {
    const support::Ending child = support::runProgram({childProgram(), "--list"}, variablesFor(libode8));
    if (!child.exitedWith(0)) throw std::runtime_error(childProgram() + " --list ended with " + child.text());
    std::vector<ScenarioName> names;
    std::istringstream lines(child.output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream parts(line);
        ScenarioName scenario;
        std::getline(parts, scenario.name, '\t');
        std::getline(parts, scenario.serialBecause, '\t');
        std::getline(parts, scenario.callbacks, '\t');
        std::getline(parts, scenario.largeIsland, '\t');
        names.push_back(scenario);
    }
    return names;
}

Record runScenario(const std::string &scenario, const Player &player) { return run(scenario, player, {}); }

std::optional<Difference> nameDifference(const std::string &scenario, const Player &expected,
                                         const Player &actual, int step) {
    const std::vector<std::string> options{"--dump-step", std::to_string(step), "--steps",
                                           std::to_string(std::max(step, 1))};
    return firstDifference(step, run(scenario, expected, options), run(scenario, actual, options));
}

}  // namespace exactness
