#include "scale/scale_options.h"

#include "support/text.h"
#include "tool_output.h"
#include "library_folders.h"
#include "world_source.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <stdexcept>

namespace scale {

namespace {

constexpr const char *kWorlds = "pioneer3at,bioloid,create,soccer,humanoids:22,humanoids:200,humanoids:2000,walls:6,world";
constexpr unsigned kMaxWorkers = 1024;

unsigned readWorkers(const std::string &text) {
    std::size_t end = 0;
    unsigned long count = 0;
    try {
        count = std::stoul(text, &end);
    } catch (const std::exception &) {
        end = 0;
    }
    if (end == 0 || end != text.size() || count < 1 || count > kMaxWorkers)
        throw std::invalid_argument("--workers: '" + text + "' is not a number from 1 to " + std::to_string(kMaxWorkers));
    return static_cast<unsigned>(count);
}

// In a build folder it is beside the library, in an installed tree beside this program. Empty: in neither.
std::string findWorker(const std::string &library) {
    for (const std::string &folder : {library, bench::folderOfThisProgram()}) {
        const std::string program = folder + "/odemt_worker";
        if (access(program.c_str(), X_OK) == 0) return program;
    }
    return "";
}

}  // namespace

std::optional<ScaleOptions> readScaleOptions(int argc, const char *const *argv, int &exitCode) {
    ScaleOptions options;
    options.measure.library = bench::folderOfOurLibrary();
    std::string worlds = kWorlds, networks, workers;
    CLI::App app("Predicts how long a frame takes with islands solved by other machines, from what is measured on this one (docs/remote.md).",
                 "odemt_scale");
    app.add_option("--worlds", worlds, "worlds and scenes, as for odemt_bench")->capture_default_str();
    app.add_option("--measured", options.measuredFiles, "files of --save, of which frames are predicted without measuring again");
    app.add_option("--networks", networks,
                   "none, 100M, 1GbE, 10GbE, 25GbE, infiniband, DELAY/RATE in ns and bytes a second; all named ones unless given");
    app.add_option("--workers", workers, "numbers of workers, 1,2,4,8,16,32,64 unless given; to validate: 1");
    app.add_flag("--validate", options.validates, "run frames with workers behind each network, simulated, and compare");
    app.add_flag("--as-they-pay", options.asTheyPay,
                 "to validate: islands go out as the library finds that it pays, which it finds out anew in each run; otherwise all");
    app.add_option("--save", options.saveFolder, "folder for what was measured, a file for each world");
    app.add_option("--csv", options.csvFile, "file with a line for each world, network and number of workers");
    app.add_option("--transport", options.measure.transport, "how the worker is reached that is measured: mpi, loopback (a thread)")
        ->capture_default_str()
        ->check(CLI::IsMember({"mpi", "loopback"}));
    app.add_option("--seconds", options.measure.seconds, "measured seconds for each world, about")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 600.0));
    app.add_option("--our-library", options.measure.library, "folder of ODE_MT's libode.so.8")->capture_default_str();
    const auto read = [&] {
        app.parse(argc, argv);
        if (options.measuredFiles.empty()) options.worlds = bench::splitWorlds(worlds);
        for (const std::string &world : options.worlds) bench::checkWorld(world);
        for (const std::string &name : support::splitAtCommas(networks)) options.networks.push_back(readNetwork(name));
        if (options.networks.empty()) options.networks = knownNetworks();
        if (workers.empty()) workers = options.validates ? "1" : "1,2,4,8,16,32,64";
        for (const std::string &count : support::splitAtCommas(workers)) options.workers.push_back(readWorkers(count));
        bench::checkLibraryFolder("--our-library", options.measure.library);
    };
    if (!bench::readCommandLine(app, read, exitCode)) return std::nullopt;
    options.measure.program = bench::folderOfThisProgram() + "/odemt_scale_child";
    options.measure.worker = findWorker(options.measure.library);
    return options;
}

}  // namespace scale
