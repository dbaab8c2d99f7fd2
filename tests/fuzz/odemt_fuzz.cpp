// Draws scripts from seeds, plays each on Debian's libode8 and on ODE_MT, and keeps those that differ, made small.
//
//   odemt_fuzz --seconds 300 --seed 1 --keep found
//   odemt_fuzz --replay found/17.script
#include "script_comparison.h"
#include "shrinking.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

using namespace fuzz;

struct Options {
    Libraries libraries{ODE_MT_FUZZ_PLAYER, ODE_MT_STOCK_LIBRARY_DIR, ODE_MT_LIBRARY_DIR};
    std::uint64_t seed = 1;
    std::uint64_t scripts = 0;  // 0: as many as there is time for
    double seconds = 60;
    unsigned times = 1;  // that each is played
    std::string keep;
    std::vector<std::string> replay;
    bool shows = false;
};

// splitmix64: every seed gives another sequence.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed * 0x9e3779b97f4a7c15u) {}

    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    unsigned below(unsigned limit) { return static_cast<unsigned>(next() % limit); }

private:
    std::uint64_t m_state;
};

RequestHeader requestOf(Random &random) {
    constexpr std::uint16_t threads[] = {0, 0, 1, 2, 2, 3, 5, 8};
    RequestHeader request{};
    request.jumps = random.below(2) != 0;
    request.messages = random.below(3) == 0;
    request.threads = threads[random.below(8)];
    request.manager = random.below(6) == 0;
    request.algorithm = static_cast<std::uint8_t>(random.below(8));
    request.instructionSet = static_cast<std::uint8_t>(random.below(4));
    request.cells = static_cast<std::uint8_t>(random.below(3) == 0 ? random.below(16) : 0);
    request.perturbation = request.threads > 1 && random.below(3) == 0 ? 1 + random.below(1000) : 0;
    request.mostCalls = 4000;
    request.seconds = 5;
    request.wallSeconds = 300;
    return request;
}

std::vector<std::uint8_t> scriptOf(Random &random) {
    constexpr unsigned lengths[] = {200, 500, 1000, 2000, 4000, 8000};
    std::vector<std::uint8_t> bytes(20 + random.below(lengths[random.below(6)]));
    for (std::uint8_t &byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    return bytes;
}

std::string settingOf(const RequestHeader &request) {
    std::string text = "# threads " + std::to_string(request.threads) + ", manager " + kManagers[request.manager % 2] + ", algorithm " +
                       kAlgorithms[request.algorithm % 8] + ", cells " + std::to_string(request.cells) + ", instruction set " +
                       std::to_string(request.instructionSet) + ", perturbation " + std::to_string(request.perturbation) + '\n';
    if (request.jumps != 0) text += "# jumps\n";
    if (request.messages != 0) text += "# messages\n";
    return text;
}

// The calls that were made, without what was told of them.
Script playedScript(const std::string &text) {
    std::string calls;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#' && line.compare(0, 4, "    ") != 0) calls += line + '\n';
    return fuzz::scriptOf(calls);
}

// What differs, made small.
std::string keep(const Options &options, Comparison &comparison, std::uint64_t seed, const RequestHeader &request,
                 const std::vector<std::uint8_t> &bytes) {
    std::cout << "seed " << seed << " differs" << std::endl;
    std::string told = "seed " + std::to_string(seed) + " differs\n" + settingOf(request) + comparison.lastDifference();
    Script script = playedScript(comparison.debian().text.size() > comparison.ours().text.size() ? comparison.debian().text
                                                                                                 : comparison.ours().text);
    const auto differs = [&](const Script &tried) { return comparison.compare(request, tried) == Verdict::different; };
    if (differs(script)) {
        comparison.setPatience(4);
        script = shrink(std::move(script), differs);
        comparison.setPatience(24);
        told += "made small:\n" + textOf(script) + comparison.difference(request, script);
    } else {
        told += "not again as text; played again:\n" + comparison.difference(request, bytes);
    }
    if (!options.keep.empty()) {
        std::filesystem::create_directories(options.keep);
        std::ofstream file(options.keep + "/" + std::to_string(seed) + ".script");
        file << settingOf(request) << textOf(script);
    }
    return told;
}

// The assertion that ended a script.
std::string lastWords(const std::string &errors) {
    const std::size_t begin = errors.rfind("ODE INTERNAL ERROR");
    return begin == std::string::npos ? "" : errors.substr(begin, errors.find('\n', begin) - begin);
}

int fuzzAway(const Options &options) {
    using Clock = std::chrono::steady_clock;
    Comparison comparison(options.libraries);
    std::map<std::string, std::uint64_t> verdicts, endings;
    std::uint64_t calls = 0, onWorkers = 0, played = 0;
    std::string differences;  // told last, where they are seen
    const Clock::time_point begin = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    for (std::uint64_t seed = options.seed; seconds() < options.seconds && (options.scripts == 0 || played < options.scripts); ++seed) {
        Random random(seed);
        RequestHeader request = requestOf(random);
        request.tells = options.times > 1;  // another time may not show the difference
        const std::vector<std::uint8_t> script = scriptOf(random);
        Verdict verdict = comparison.compare(request, script);
        for (unsigned i = 1; i < options.times && verdict == Verdict::same; ++i) verdict = comparison.compare(request, script);
        ++played;
        ++verdicts[nameOf(verdict)];
        ++endings[comparison.debian().ending() + ' ' + lastWords(comparison.debian().errors)];
        calls += comparison.ours().header.calls;
        onWorkers += comparison.ours().header.workers > 1;
        if (options.shows) std::cout << settingOf(request) << comparison.ours().text;
        if (verdict == Verdict::different) differences += keep(options, comparison, seed, request, script);
    }
    std::cout << played << " scripts, " << calls << " calls in " << seconds() << " s; " << onWorkers << " with two workers at least\n";
    for (const auto &[name, count] : verdicts) std::cout << "  " << name << ": " << count << '\n';
    for (const auto &[name, count] : endings) std::cout << "  " << name << ": " << count << '\n';
    std::cout << differences;
    return differences.empty() ? 0 : 1;
}

// Scripts that were kept, each in many settings.
int replay(const Options &options) {
    Comparison comparison(options.libraries);
    int different = 0;
    for (const std::string &path : options.replay) {
        std::ifstream file(path);
        std::stringstream text;
        text << file.rdbuf();
        if (!file) throw std::runtime_error(path + " cannot be read");
        const Script script = fuzz::scriptOf(text.str());
        for (const unsigned threads : {0u, 2u, 3u, 8u}) {
            for (std::uint8_t algorithm = 0; algorithm < 8; ++algorithm) {
                RequestHeader request{};
                request.threads = static_cast<std::uint16_t>(threads);
                request.algorithm = algorithm;
                request.jumps = text.str().find("# jumps") != std::string::npos;
                request.messages = text.str().find("# messages") != std::string::npos;
                request.seconds = 20;
                request.wallSeconds = 300;
                if (comparison.compare(request, script) == Verdict::same) continue;
                ++different;
                std::cout << path << " differs\n" << settingOf(request) << comparison.difference(request, script);
            }
        }
    }
    std::cout << options.replay.size() << " scripts in 32 settings each, " << different << " differences\n";
    return different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Compares ODE_MT with Debian's libode8 on drawn scripts of calls.");
    app.add_option("--seed", options.seed, "first seed");
    app.add_option("--scripts", options.scripts, "how many, 0: as many as there is time for");
    app.add_option("--seconds", options.seconds, "time")->check(CLI::PositiveNumber);
    app.add_option("--times", options.times, "that each script is played, to find what only some schedules show");
    app.add_option("--keep", options.keep, "folder for scripts that differ");
    app.add_option("--replay", options.replay, "scripts that were kept, to play instead")->check(CLI::ExistingFile);
    app.add_flag("--show", options.shows, "print the scripts");
    app.add_option("--ours", options.libraries.ours, "folder of ODE_MT's library");
    CLI11_PARSE(app, argc, argv);
    try {
        return options.replay.empty() ? fuzzAway(options) : replay(options);
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz: " << error.what() << '\n';
        return 2;
    }
}
