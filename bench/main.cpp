// odemt_bench: worlds × engines, interleaved, as a table. docs/tools.md explains the method.
#include "comparison.h"
#include "tool_output.h"
#include "options.h"
#include "progress.h"
#include "report.h"
#include "report/page.h"
#include "result_file.h"
#include "support/text.h"
#include "world_source.h"

#include <algorithm>

namespace {

// Saves the results of all worlds measured so far, so that an interrupt keeps them.
void save(const std::vector<bench::WorldResult> &results, const bench::Options &options) {
    const std::string json = bench::reportJson(results, options.withAverages);
    bench::writeResultFile(options.jsonFile, json);
    bench::writeResultFile(options.csvFile, bench::reportCsv(results));
    if (!options.samplesFile.empty())
        bench::writeResultFile(options.samplesFile, bench::reportSamples(results));
    if (!options.htmlFile.empty()) bench::writeResultFile(options.htmlFile, report::page(json, {}));
}

bench::WorldResult measure(const std::string &world, const bench::Options &options, bench::Progress &progress,
                           const std::function<void(const bench::WorldResult &)> &onRound) {
    bench::Competitors competitors;
    const auto ours = std::count_if(options.engines.begin(), options.engines.end(), [](const bench::Engine &engine) { return engine.isOurs(); });
    const std::size_t traces = options.worlds.size() * static_cast<std::size_t>(ours);
    for (const bench::Engine &engine : options.engines) {
        bench::ChildSettings child = options.child;
        child.traceFile = bench::traceFileOf(options.traceFile, world, engine.name(), traces);
        child.whileLoading = [&progress, world, engine] { progress.showLoading(world, engine); };
        competitors.push_back(std::make_unique<bench::ChildCompetitor>(engine, world, child));
    }
    return bench::race(world, competitors, options.race, onRound);
}

bool compare(const bench::Options &options) {
    std::vector<std::string> files = {options.jsonFile, options.csvFile};
    if (!options.samplesFile.empty()) files.push_back(options.samplesFile);
    if (!options.htmlFile.empty()) files.push_back(options.htmlFile);
    if (!options.traceFile.empty()) files.push_back(options.traceFile);
    for (const std::string &file : files) bench::checkWritable(file);

    bool isClean = true;
    std::vector<bench::WorldResult> results;
    bench::Progress progress(options.worlds.size(), options.race.stop);
    progress.announce(options.worlds, options.engines);
    for (std::size_t i = 0; i < options.worlds.size(); ++i) {
        results.push_back(measure(options.worlds[i], options, progress,
                                  [&](const bench::WorldResult &result) { progress.show(i, result); }));
        progress.clear();
        save(results, options);  // before anything is printed, which may fail
        isClean = results.back().isClean() && isClean;
        bench::print(bench::reportText(results.back()));
    }
    bench::print(bench::reportCurves(results) + bench::reportScaling(results) + "Figures: " +
                 support::printable(options.jsonFile + ", " + options.csvFile) + "\n" + bench::reportSentence(results));
    if (!isClean) bench::print("AN ENGINE FAILED OR GAVE OTHER RESULTS: see above.\n");
    return isClean;
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const std::optional<bench::Options> options = bench::readOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    try {
        if (!options->compared.empty())
            bench::print(bench::compareResults(options->compared[0], options->compared[1]));
        else if (options->list)
            bench::print(bench::listWorlds());
        else
            return compare(*options) ? 0 : 1;
        return 0;
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return 1;
    }
}
