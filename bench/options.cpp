#include "options.h"

#include "support/text.h"
#include "tool_output.h"
#include "library_folders.h"
#include "platform.h"
#include "command_line.h"
#include "result_file.h"
#include "world_source.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <sstream>
#include <thread>

namespace bench {

namespace {

const char *const kDescription =
    "Compares ODE_MT with the system's libode: runs worlds on both, in turns, and prints how long a frame\n"
    "takes on each, how much faster that is than the first engine, and whether the results are the same.\n";

const char *const kFooter =
    "Engines:\n"
    "  stock         the system's libode on one thread\n"
    "  stock:PATH    another libode.so.8 on one thread: a file of any name, or a folder that has one\n"
    "  stock-pool:N  the system's libode with its own pool of N threads\n"
    "  ours:N        ODE_MT with N threads (0: serial, auto: every core)\n"
    "  ours:N/openmp ODE_MT with this thread manager (pthread, openmp); ours:N/lcp: this algorithm;\n"
    "                ours:N/concurrent, ours:N/independent: callbacks on several threads;\n"
    "                ours:N/cells=K: a grid of K cells an axis\n"
    "  stock-pool, ours: one for (the largest of / each of) --threads\n"
    "\nExamples:\n"
    "  odemt_bench                                    the four benchmark worlds of the thesis's chapter 3\n"
    "  odemt_bench --worlds thesis                    these and the four of its table 2.1\n"
    "  odemt_bench --worlds pioneer3at:440,create:620 worlds with more static shapes\n"
    "  odemt_bench --worlds humanoids:22,stacks:100   two scenes\n"
    "  odemt_bench --worlds pile:4000,sap --engines stock,ours:2 --seconds 60\n"
    "  odemt_bench --worlds pile:1000..32000 --engines stock,ours:2\n"
    "                                                 time over size: 1000, 2000, 4000 …\n"
    "  odemt_bench --worlds my/world.sdf --threads 2,4,8\n"
    "  odemt_bench --engines stock,stock:build/my/libode.so.8,ours:2\n"
    "\nThe exit code is 0 if all engines ran and agreed, 1 if one failed or differed, 2 for a wrong "
    "option.\n";

// Checked by hand, because CLI11 prints the largest double with all its 309 digits and lets NaN pass.
const CLI::Validator kSeconds = numberIn(1e-3, 1e6), kShare = numberIn(1e-6, 1);

std::vector<std::string> splitEngines(const std::string &list) {
    std::vector<std::string> engines;
    for (const std::string &word : support::splitAtCommas(list)) engines.push_back(support::withoutEscapes(word));
    return engines;
}

// What the loader would find for an engine. Throws std::invalid_argument if that is missing or, for stock, ODE_MT itself.
void checkLibrary(const Engine &engine, const ChildSettings &settings) {
    if (engine.isOurs()) return checkLibraryFolder("--our-library", settings.oursFolder);
    if (engine.path.empty()) checkLibraryFolder("--stock-library", settings.stockFolder);
    const std::string file = libraryAt(engine.path.empty() ? settings.stockFolder : engine.path);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        throw std::invalid_argument("engine '" + engine.name() + "': no such file: '" + file + "'");
    if (isOurLibrary(file))
        throw std::invalid_argument("engine '" + engine.name() + "': '" + file +
                                    "' is ODE_MT itself, as where the package libode8-mt is installed: it would be measured against itself. For "
                                    "Debian's, as --stock-library: " +
                                    commandsForStockLibrary());
}

// The loader would give it to all engines.
void checkPreloaded() {
    for (const std::string &library : preloadedLibraries())
        if (isOurLibrary(library))
            throw std::invalid_argument("LD_PRELOAD: '" + library + "' is ODE_MT itself, on which all engines would run: unset it");
}

// 0, 1, 2, 4, … up to the number of cores.
std::string defaultThreads() {
    std::string list = "0,1";
    const unsigned cores = std::thread::hardware_concurrency();
    for (unsigned threads = 2; threads < cores; threads *= 2) list += "," + std::to_string(threads);
    return cores > 1 ? list + "," + std::to_string(cores) : list;
}

// The words of the command line that need more than conversion.
struct Words {
    std::string worlds = "pioneer3at,bioloid,create,soccer";
    std::string engines = "stock,stock-pool,ours";
    std::string threads = defaultThreads();
    std::string manager;
    double limitSeconds = 120;
    bool isQuick = false;
};

void addOptions(CLI::App &app, Words &words, Options &options) {
    StoppingRule &stop = options.race.stop;
    app.add_option(
           "--worlds", words.worlds,
           "SDF worlds, .sdf files (a comma in a name: \\,) and scenes; 'thesis': the eight\n"
           "worlds of the thesis; --list shows all")
        ->capture_default_str();
    app.add_option("--engines", words.engines, "engines (a comma in a path: \\,); speed-ups refer to the first")
        ->capture_default_str();
    app.add_option("--threads", words.threads, "thread counts of 'ours'")->capture_default_str();
    app.add_option("--manager", words.manager, "thread manager of 'ours': pthread or openmp");
    app.add_option("--seconds", stop.maximumSeconds,
                   "most measured seconds for a world, all engines together")
        ->capture_default_str()
        ->check(kSeconds);
    app.add_option("--frames", stop.maximumFrames, "most frames for each engine, warm-up not counted")
        ->capture_default_str()
        ->check(wholeNumberIn(1, 1'000'000'000));
    app.add_option("--tolerance", stop.tolerance,
                   "stop when the last ten running averages (one every 100 frames) lie within this share")
        ->capture_default_str()
        ->check(kShare);
    app.add_option("--warm-up", options.race.warmUpFrames,
                   "first frames, not timed (fewer if they take too long)")
        ->capture_default_str()
        ->check(wholeNumberIn(0, 1'000'000));
    app.add_option("--warm-up-seconds", options.race.warmUpSeconds,
                   "seconds of the first engine after which the warm-up takes too long; sizes of a world\n"
                   "compare best with the same number of frames")
        ->capture_default_str()
        ->check(kSeconds);
    app.add_option("--timeout", words.limitSeconds, "seconds after which an engine counts as hanging")
        ->capture_default_str()
        ->check(kSeconds);
    app.add_option("--json", options.jsonFile, "file for all figures")->capture_default_str();
    app.add_option("--csv", options.csvFile, "file with one line for each world and engine")
        ->capture_default_str();
    app.add_option("--samples", options.samplesFile,
                   "file for the real-time factor of each second that each engine ran;\n"
                   "measuring then does not end before --seconds or --frames");
    app.add_option("--html", options.htmlFile, "file for a page with tables and plots of all figures (docs/tools.md)");
    app.add_option("--trace", options.traceFile,
                   "file for what each thread of ours does, to be opened in ui.perfetto.dev; of several\n"
                   "worlds or engines each has a file with its name in it");
    app.add_flag("!--no-averages", options.withAverages,
                 "leave the kept running averages out of the JSON file");
    app.add_option("--stock-library", options.child.stockFolder, "folder of the libode.so.8 of stock and stock-pool")
        ->capture_default_str();
    app.add_option("--our-library", options.child.oursFolder, "folder of ODE_MT's libode.so.8")
        ->capture_default_str();
    app.add_flag("--ignore-unsupported", options.child.ignoreUnsupported,
                 "leave out elements of an SDF world that the loader does not know");
    app.add_flag("--time-callbacks", options.child.timeCallbacks,
                 "time near-callbacks separately; the time of reading the clock is subtracted");
    app.add_flag("--serial-share", options.child.serialShare,
                 "tell which part of the work of ours is one thread's, and how much more cores can gain at most; frames are recorded, which takes a "
                 "little time");
    app.add_flag("--quick", words.isQuick, "a first impression of the four benchmark worlds in half a minute: stock, and ours on all cores");
    app.add_option("--compare", options.compared, "compare two JSON files of earlier runs, the older one first, and measure nothing")
        ->expected(2)
        ->check(CLI::ExistingFile);
    app.add_flag("--list", options.list, "list worlds, scenes and modifiers");
}

// What the user has set stays.
void makeQuick(const CLI::App &app, Words &words, Options &options) {
    if (app.count("--engines") == 0) words.engines = "stock,ours";
    if (app.count("--threads") == 0) words.threads = "auto";
    if (app.count("--seconds") == 0) options.race.stop.maximumSeconds = 4;
    if (app.count("--warm-up-seconds") == 0) options.race.warmUpSeconds = 0.5;
}

void interpret(const Words &words, Options &options) {
    options.worlds = splitWorlds(words.worlds);
    if (options.worlds.empty()) throw std::invalid_argument("--worlds: no worlds given");
    for (const std::string &world : options.worlds) checkWorld(world);
    options.engines = readEngines(splitEngines(words.engines), support::split(words.threads, ','), words.manager);
    for (const Engine &engine : options.engines) checkLibrary(engine, options.child);
    checkPreloaded();
    std::vector<std::string> files = {options.jsonFile, options.csvFile};
    if (!options.samplesFile.empty()) files.push_back(options.samplesFile);
    if (!options.htmlFile.empty()) files.push_back(options.htmlFile);
    if (!options.traceFile.empty()) files.push_back(options.traceFile);
    for (const std::string &world : options.worlds)
        if (const std::string file = readWorldSpec(world).name; std::filesystem::is_regular_file(file)) files.push_back(file);
    if (options.jsonFile.empty()) throw std::invalid_argument("--json: a file of results has no name");
    if (options.csvFile.empty()) throw std::invalid_argument("--csv: a file of results has no name");
    checkDistinct(files);
    if (!options.samplesFile.empty()) options.race.stop.minimumSeconds = options.race.stop.maximumSeconds;
    options.child.limit = std::chrono::milliseconds(static_cast<long>(1000 * words.limitSeconds));
}

}  // namespace

std::optional<Options> readOptions(int argc, const char *const *argv, int &exitCode) {
    Options options;
    options.child.program = folderOfThisProgram() + "/odemt_bench_child";
    options.child.stockFolder = folderOfStockLibrary();
    options.child.oursFolder = folderOfOurLibrary();
    options.jsonFile = "results/bench.json";
    options.csvFile = "results/bench.csv";
    Words words;
    CLI::App app(kDescription, "odemt_bench");
    app.footer(kFooter);
    addOptions(app, words, options);
    const auto read = [&] {
        app.parse(argc, argv);
        if (words.isQuick) makeQuick(app, words, options);
        if (!options.list && options.compared.empty()) interpret(words, options);
    };
    if (!readCommandLine(app, read, exitCode)) return std::nullopt;
    return options;
}

}  // namespace bench
