// Draws values of all environment variables that docs/settings.md lists, runs a small scene with them on ODE_MT, and
// compares with what that page promises: the same results, what is taken, and what is reported.
//
//   odemt_fuzz_environment --seconds 300 --seed 1
#include "driver/campaign.h"
#include "driver/drawn_text.h"
#include "support/child_run.h"
#include "driver/message_text.h"
#include "support/temporary_folder.h"
#include "environment/variable_table.h"
#include "support/text_file.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

namespace {

using namespace fuzz_environment;
using support::Ending;
using fuzz_driver::Random;
using fuzz_driver::Verdict;
using nlohmann::json;

using Environment = std::map<std::string, std::string>;

struct Run {
    Ending ending;
    json ready, batch;  // as odemt_bench_child sends them

    bool isWhole() const {
        return ending.exited() && ending.exitCode() == 0 && ready.is_object() && batch.is_object();
    }
};

Run simulate(const std::string &scene, const Environment &environment) {
    support::Limits limits;
    limits.cpuSeconds = 120;
    limits.seconds = 300;  // machines may be busy
    limits.memory = std::size_t{3} << 30;
    const auto start = [&]() -> int {
        for (const auto &[name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
        setenv("LD_LIBRARY_PATH", ODE_MT_FUZZ_LIBRARY_DIR, 1);
        execl(ODE_MT_FUZZ_BENCH_CHILD, ODE_MT_FUZZ_BENCH_CHILD, "--world", scene.c_str(),
              static_cast<char *>(nullptr));
        return 126;
    };
    Run run;
    run.ending = support::runFunction(start, limits, "{\"frames\":20}\n");
    std::istringstream lines(run.ending.output);
    for (std::string line; std::getline(lines, line);) {
        const json told = json::parse(line, nullptr, false);
        if (told.is_object() && told.contains("ready")) run.ready = told["ready"];
        if (told.is_object() && told.contains("batch")) run.batch = told["batch"];
    }
    return run;
}

std::string textOf(const Environment &environment) {
    std::string text;
    for (const auto &[name, value] : environment) text += name + "='" + fuzz_driver::shown(value, 200) + "' ";
    return text;
}

class Fuzzer {
public:
    explicit Fuzzer(const fuzz_driver::CampaignOptions &options)
        : m_options(options),
          m_table(readVariableTable(support::readWhatIsThere(ODE_MT_FUZZ_SETTINGS))),
          m_heuristics(readHeuristicNames(support::readWhatIsThere(ODE_MT_FUZZ_HEURISTICS))) {
        for (const Variable &variable : m_table) unsetenv(variable.name.c_str());
    }

    std::size_t countOfVariables() const { return m_table.size(); }

    Verdict play(std::uint64_t seed) {
        static const std::vector<std::string> scenes = {"rover:3",    "stacks:4",   "pile:40",
                                                        "ragdolls:2", "spheres:20", "pile:60,sap",
                                                        "vehicles:2", "rays:3"};
        Random random(seed);
        const std::string scene = random.of(scenes);
        Environment environment;
        for (const Variable &variable : m_table)
            if (random.oneIn(2)) environment[variable.name] = drawValue(variable, random);
        if (random.oneIn(4)) environment["LC_ALL"] = random.oneIn(2) ? "de_DE.UTF-8" : "C.UTF-8";
        if (random.oneIn(8))
            environment["ODE_MT_" + std::string(1, static_cast<char>('A' + random.below(26)))] =
                fuzz_driver::drawText(random);
        if (m_options.shows) std::cout << seed << ": " << scene << ' ' << textOf(environment) << std::endl;
        const Run run = simulate(scene, environment);
        const std::string wrong = whatIsWrong(scene, environment, run);
        return {run.ending.text(),
                wrong.empty() ? "" : wrong + "\n  " + scene + " with " + textOf(environment)};
    }

private:
    // Words of the table, numbers about the ends of the range, and anything.
    std::string drawValue(const Variable &variable, Random &random) const {
        static const std::vector<std::string> files = {"", "/dev/null", "/dev/full", "/nonexistent/trace.json"};
        if (variable.name == "ODE_MT_TRACE" || variable.name == "ODE_MT_STATISTICS") return random.of(files);  // any name is one
        std::string value;
        switch (random.below(variable.takesNumber || variable.takesList ? 6 : 3)) {
            case 0:
                value = fuzz_driver::drawText(random);
                break;
            case 1:
            case 2:
                value = variable.words.empty() ? "1" : random.of(variable.words);
                if (random.oneIn(8)) value += random.oneIn(2) ? " " : "x";
                if (random.oneIn(12)) value[0] = static_cast<char>(value[0] - 'a' + 'A');
                break;
            default:
                value = variable.takesNumber ? drawNumberFor(variable, random) : drawList(random);
        }
        value.erase(std::remove(value.begin(), value.end(), '\0'), value.end());
        return value;
    }

    static std::string drawNumberFor(const Variable &variable, Random &random) {
        const long long least = variable.least.value_or(0), most = variable.most.value_or(1000);
        switch (random.below(4)) {
            case 0:
                return std::to_string(least - 1 + static_cast<long long>(random.below(3)));
            case 1:
                return std::to_string(most - 1 + static_cast<long long>(random.below(3)));
            case 2:
                return std::string(random.below(3), '0') + std::to_string(random.below(9));
            default:
                return std::to_string(least + static_cast<long long>(random.below(static_cast<std::size_t>(
                                                  std::min(most - least + 1, 12LL)))));
        }
    }

    std::string drawList(Random &random) const {
        std::string list;
        for (std::size_t i = 1 + random.below(4); i > 0; --i)
            list += (list.empty() ? "" : ",") +
                    (random.oneIn(10) ? fuzz_driver::drawGarbage(random) : random.of(m_heuristics));
        return random.oneIn(10) ? list + "," : list;
    }

    std::string whatIsWrong(const std::string &scene, const Environment &environment, const Run &run) {
        if (!run.isWhole())
            return "an end by " + run.ending.text() + ": " +
                   fuzz_driver::shown(run.ending.errors + run.ending.output, 1500);
        if (const std::string report = fuzz_driver::sanitizerReportIn(run.ending.errors); !report.empty())
            return "a sanitizer: " + report;
        if (run.batch.at("hash") != hashOf(scene, solverOf(environment))) return "another state: " + run.batch.dump();
        const std::string level = levelIn(environment);
        for (const Variable &variable : m_table) {
            const auto set = environment.find(variable.name);
            const Meaning meaning =
                meaningOf(variable, set == environment.end() ? "" : set->second, m_heuristics);
            if (meaning.understanding == Understanding::Untold) continue;
            if (const std::string wrong = wrongReport(variable, meaning, level, run.ending.errors);
                !wrong.empty())
                return wrong;
            if (const std::string wrong = wrongChoice(variable, meaning, run.ready); !wrong.empty())
                return wrong;
        }
        if (const std::string wrong = wrongUnknown(environment, level, run.ending.errors); !wrong.empty()) return wrong;
        return wrongLines(run.ending.errors, level);
    }

    // A name that is not the library's is reported once, unless it is as good as unset.
    std::string wrongUnknown(const Environment &environment, const std::string &level, const std::string &errors) const {
        for (const auto &[name, value] : environment) {
            const auto isIt = [&name = name](const Variable &variable) { return variable.name == name; };
            if (name.compare(0, 7, "ODE_MT_") != 0 || std::any_of(m_table.begin(), m_table.end(), isIt)) continue;
            const int expected = value.c_str()[0] != '\0' && level != "error" ? 1 : 0;
            const std::string begin = "ODE_MT warning: " + name + " is no variable of this library";
            int count = 0;
            std::istringstream lines(errors);
            for (std::string line; std::getline(lines, line);) count += line.compare(0, begin.size(), begin) == 0 ? 1 : 0;
            if (count != expected) return "reports of the unknown " + name + ": " + std::to_string(count) + " instead of " + std::to_string(expected);
        }
        return {};
    }

    const json &hashOf(const std::string &scene, const Environment &solver) {
        json &hash = m_hashes[scene + ' ' + textOf(solver)];
        if (hash.is_null()) hash = simulate(scene, solver).batch.at("hash");
        return hash;
    }

    // What decides about the bits: nothing but the solver "fast" and its settings.
    static Environment solverOf(const Environment &environment) {
        Environment solver;
        const auto chosen = environment.find("ODE_MT_SOLVER");
        if (chosen == environment.end() || chosen->second != "fast") return solver;
        for (const char *const name : {"ODE_MT_SOLVER", "ODE_MT_SOLVER_TOLERANCE", "ODE_MT_WARM_START"})
            if (const auto found = environment.find(name); found != environment.end()) solver.insert(*found);
        return solver;
    }

    std::string levelIn(const Environment &environment) const {
        const auto set = environment.find("ODE_MT_LOG");
        for (const Variable &variable : m_table)
            if (variable.name == "ODE_MT_LOG" && set != environment.end())
                return meaningOf(variable, set->second, m_heuristics).taken;
        return "warning";
    }

    static std::string wrongReport(const Variable &variable, const Meaning &meaning, const std::string &level,
                                   const std::string &errors) {
        const bool isWrong = meaning.understanding == Understanding::OutOfRange ||
                             meaning.understanding == Understanding::NotUnderstood;
        const int expected = isWrong && level != "error" ? 1 : 0;
        const std::string begin = "ODE_MT warning: " + variable.name + " is '";
        int count = 0;
        std::istringstream lines(errors);
        for (std::string line; std::getline(lines, line);) {
            if (line.compare(0, begin.size(), begin) != 0) continue;
            ++count;
            const bool tells =
                line.find("known: ") != std::string::npos || line.find("it takes ") != std::string::npos;
            if (!tells) return "a report that does not tell what is known: " + fuzz_driver::shown(line);
        }
        if (count == expected) return {};
        return "reports of " + variable.name + ": " + std::to_string(count) + " instead of " +
               std::to_string(expected) + ", " + fuzz_driver::shown(errors, 1000);
    }

    // Compares the variables whose values the library reports.
    static std::string wrongChoice(const Variable &variable, const Meaning &meaning, const json &ready) {
        static const std::map<std::string, const char *> members = {{"ODE_MT_THREADS", "threads"},
                                                                    {"ODE_MT_ALGORITHM", "algorithm"},
                                                                    {"ODE_MT_CALLBACKS", "callbacks"},
                                                                    {"ODE_MT_GRID_CELLS", "gridCells"},
                                                                    {"ODE_MT_THREAD_MANAGER", "manager"}};
        const auto member = members.find(variable.name);
        if (member == members.end() || meaning.taken.empty()) return {};
        const json &value = ready.at(member->second);
        const std::string taken = value.is_string() ? value.get<std::string>() : value.dump();
        if (meaning.taken == "auto" && variable.takesNumber) {
            const bool isAuto =
                variable.name == "ODE_MT_THREADS" ? value.get<int>() >= 1 : value.get<int>() == 0;
            return isAuto ? "" : variable.name + " is not auto, but " + taken + ":";
        }
        return taken == meaning.taken ? ""
                                      : variable.name + " is " + taken + " instead of " + meaning.taken + ":";
    }

    static std::string wrongLines(const std::string &errors, const std::string &level) {
        std::istringstream lines(errors);
        for (std::string line; std::getline(lines, line);) {
            if (line.compare(0, 7, "ODE_MT ") != 0)
                return "a line that does not begin with ODE_MT: " + fuzz_driver::shown(line);
            if (const std::string wrong = fuzz_driver::whatIsNoPlainLine(line); !wrong.empty())
                return "a line that " + wrong + ": " + fuzz_driver::shown(line);
            const bool isQuiet = level == "warning" || level == "error";
            if (isQuiet && line.compare(0, 11, "ODE_MT info") == 0)
                return "words at level " + level + ": " + fuzz_driver::shown(line);
        }
        return {};
    }

    const fuzz_driver::CampaignOptions &m_options;
    const std::vector<Variable> m_table;
    const std::vector<std::string> m_heuristics;
    std::map<std::string, json> m_hashes;  // of scenes, without variables
};

}  // namespace

int main(int argc, char **argv) {
    fuzz_driver::CampaignOptions options;
    int exitCode = 0;
    if (!fuzz_driver::readCampaignOptions(argc, argv, "Runs scenes with drawn environment variables.",
                                          options, nullptr, exitCode))
        return exitCode;
    try {
        fuzz_driver::setSanitizerOptions();
        Fuzzer fuzzer(options);
        std::cout << fuzzer.countOfVariables() << " variables\n";
        return fuzz_driver::runCampaign(options, "environments",
                                        [&](std::uint64_t seed) { return fuzzer.play(seed); });
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz_environment: " << error.what() << '\n';
        return 2;
    }
}
