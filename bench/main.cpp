// odemt_bench: worlds × engines, in turns, as a table. docs/bench.md explains the method.
#include "options.h"
#include "progress.h"
#include "report.h"
#include "world_source.h"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

bool save(const std::string &file, const std::string &text) {
    std::error_code ignored;  // the open below fails if the folder could not be made
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    std::ofstream stream(file);
    stream << text;
    stream.close();
    if (!stream) std::cerr << "cannot write '" << file << "'\n";
    return static_cast<bool>(stream);
}

bench::WorldResult measure(const std::string &world, const bench::Options &options,
                           const std::function<void(const bench::WorldResult &)> &onRound) {
    bench::Competitors competitors;
    for (const bench::Engine &engine : options.engines)
        competitors.push_back(std::make_unique<bench::ChildCompetitor>(engine, world, options.child));
    return bench::race(world, competitors, options.race, onRound);
}

}  // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const std::optional<bench::Options> options = bench::readOptions(argc, argv, exitCode);
    if (!options) return exitCode;
    if (options->list) {
        std::cout << bench::listWorlds();
        return 0;
    }

    bool isClean = true;
    std::vector<bench::WorldResult> results;
    bench::Progress progress(options->worlds.size(), options->race.stop);
    for (std::size_t i = 0; i < options->worlds.size(); ++i) {
        results.push_back(measure(options->worlds[i], *options,
                                  [&](const bench::WorldResult &result) { progress.show(i, result); }));
        progress.clear();
        std::cout << bench::reportText(results.back()) << std::flush;
        isClean = results.back().isClean() && isClean;
    }
    std::cout << bench::reportCurves(results) << bench::reportScaling(results);
    const bool savedJson = save(options->jsonFile, bench::reportJson(results, options->withAverages));
    const bool savedCsv = save(options->csvFile, bench::reportCsv(results));
    const bool savedSamples =
        options->samplesFile.empty() || save(options->samplesFile, bench::reportSamples(results));
    const bool saved = savedJson && savedCsv && savedSamples;
    if (saved) std::cout << "Figures: " << options->jsonFile << ", " << options->csvFile << "\n";
    if (!isClean) std::cout << "AN ENGINE FAILED OR GAVE OTHER RESULTS: see above.\n";
    return isClean && saved ? 0 : 1;
}
