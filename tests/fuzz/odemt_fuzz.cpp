// Draws scripts from seeds, plays each on Debian's libode8 and on ODE_MT, and keeps those that differ, made small.
//
//   odemt_fuzz --seconds 300 --seed 1 --keep found
//   odemt_fuzz --replay found/17.script
//   odemt_fuzz --fast --seconds 300             the solver fast, compared with its own run on one thread
#include "input.h"
#include "kept_difference.h"
#include "script_comparison.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace {

using namespace fuzz;

struct Options {
    Libraries libraries{ODE_MT_FUZZ_PLAYER, ODE_MT_STOCK_LIBRARY_DIR, ODE_MT_LIBRARY_DIR};
    std::uint64_t seed = 1;
    bool isFresh = false;
    std::uint64_t scripts = 0;  // 0: as many as there is time for
    double seconds = 60;
    unsigned times = 1;  // that each is played
    std::string keep;
    std::vector<std::string> replay;
    std::string write;
    bool shows = false;
    bool untilDifference = false;
};

// The assertion that ended a script.
std::string lastWords(const std::string &errors) {
    const std::size_t begin = errors.rfind("ODE INTERNAL ERROR");
    return begin == std::string::npos ? "" : errors.substr(begin, errors.find('\n', begin) - begin);
}

// Another one each time, and so far apart that runs do not come to the same scripts.
std::uint64_t freshSeed() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return 1000000 * static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
}

int fuzzAway(const Options &options) {
    using Clock = std::chrono::steady_clock;
    const std::uint64_t first = options.isFresh ? freshSeed() : options.seed;
    std::cout << "first seed " << first << std::endl;
    Comparison comparison(options.libraries);
    std::map<std::string, std::uint64_t> verdicts, endings;
    std::uint64_t calls = 0, onWorkers = 0, direct = 0, played = 0;
    std::string differences;  // printed last, where they are visible
    const Clock::time_point begin = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    const auto isOver = [&] {
        return seconds() >= options.seconds || (options.scripts != 0 && played == options.scripts) ||
               (options.untilDifference && !differences.empty());
    };
    for (std::uint64_t seed = first; !isOver(); ++seed) {
        const std::vector<std::uint8_t> bytes = bytesOf(seed);
        Input input = inputOf(bytes.data(), bytes.size());
        input.request.tells = options.times > 1;  // another time may not show the difference
        Verdict verdict = comparison.compare(input.request, input.script);
        for (unsigned i = 1; i < options.times && verdict == Verdict::same; ++i) verdict = comparison.compare(input.request, input.script);
        if (verdict == Verdict::different && comparison.isUpstreamUnset(input.request)) verdict = Verdict::upstreamUndefined;
        ++played;
        ++verdicts[nameOf(verdict)];
        ++endings[comparison.reference().ending() + ' ' + lastWords(comparison.reference().errors)];
        calls += comparison.ours().header.calls;
        onWorkers += comparison.ours().header.workers > 1;
        direct += comparison.ours().header.directIslands > 0;
        if (options.shows) std::cout << settingOf(input.request) << comparison.ours().text;
        if (verdict != Verdict::different) continue;
        std::cout << "seed " << seed << " differs" << std::endl;
        differences += options.untilDifference ? settingOf(input.request) + comparison.difference(input.request, input.script)
                                               : keepDifference(comparison, input, "seed-" + std::to_string(seed), options.keep);
    }
    std::cout << played << " scripts, " << calls << " calls in " << seconds() << " s, " << static_cast<double>(played) / seconds()
              << " scripts a second; " << onWorkers << " with two workers at least, " << direct << " with the direct solver\n";
    for (const auto &[name, count] : verdicts) std::cout << "  " << name << ": " << count << '\n';
    for (const auto &[name, count] : endings) std::cout << "  " << name << ": " << count << '\n';
    std::cout << differences;
    return differences.empty() ? 0 : 1;
}

// For libFuzzer to begin with: each seed's bytes in a file.
int writeInputs(const Options &options) {
    std::filesystem::create_directories(options.write);
    for (std::uint64_t seed = options.seed; seed < options.seed + options.scripts; ++seed) {
        const std::vector<std::uint8_t> bytes = bytesOf(seed);
        std::ofstream file(options.write + "/seed-" + std::to_string(seed), std::ios::binary);
        file.write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        if (!file) throw std::runtime_error(options.write + " cannot be written to");
    }
    return 0;
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
        const Script script = scriptOf(text.str());
        std::optional<bool> isUnset;  // what upstream does is the same in all settings
        for (const unsigned threads : {0u, 2u, 3u, 8u}) {
            for (std::uint8_t algorithm = 0; algorithm < 8; ++algorithm) {
                RequestHeader request{};
                request.threads = static_cast<std::uint16_t>(threads);
                request.algorithm = algorithm;
                request.disturbs = threads > 1 && algorithm % 2 != 0;
                request.jumps = text.str().find("# jumps") != std::string::npos;
                request.messages = text.str().find("# messages") != std::string::npos;
                request.seconds = 20;
                request.wallSeconds = 300;
                const Verdict verdict = comparison.compare(request, script);
                if (verdict == Verdict::same || verdict == Verdict::signOfNaN) continue;
                if (!isUnset) isUnset = comparison.isUpstreamUnset(request);
                if (*isUnset) continue;
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
    CLI::Option *seed = app.add_option("--seed", options.seed, "first seed");
    app.add_flag("--fresh", options.isFresh, "first seed by the clock")->excludes(seed);
    app.add_option("--scripts", options.scripts, "how many, 0: as many as there is time for");
    app.add_option("--seconds", options.seconds, "time")->check(CLI::PositiveNumber);
    app.add_option("--times", options.times, "that each script is played, to find what only some schedules show");
    app.add_option("--keep", options.keep, "folder for scripts that differ");
    app.add_option("--replay", options.replay, "scripts that were kept, to play instead")->check(CLI::ExistingFile);
    app.add_flag("--until-difference", options.untilDifference, "end at the first script that differs, and do not make it small");
    app.add_option("--write", options.write, "folder for the bytes of --scripts scripts, which are not played");
    app.add_flag("--show", options.shows, "print the scripts");
    app.add_flag("--fast", options.libraries.isFast, "compare the solver fast with its own run on one thread without vectors");
    app.add_option("--player", options.libraries.player, "odemt_fuzz_player to play with");
    app.add_option("--ours", options.libraries.ours, "folder of ODE_MT's library");
    app.add_option("--oracle", options.libraries.debian, "folder of the libode.so.8 to compare with");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!options.write.empty()) return writeInputs(options);
        return options.replay.empty() ? fuzzAway(options) : replay(options);
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz: " << error.what() << '\n';
        return 2;
    }
}
