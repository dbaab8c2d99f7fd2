#include "check/check_options.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "support/text.h"
#include "tool_output.h"
#include "library_folders.h"
#include "platform.h"
#include "command_line.h"

namespace check {

namespace {

const char *const kDescription =
    "Runs a program on the system's libode8 and on ODE_MT, unchanged, and says whether it computes the same: after each\n"
    "step of each world the states of all bodies are compared, bit by bit.\n"
    "\n"
    "odemt_check [OPTIONS] -- PROGRAM [ARGUMENT...]\n";

const char *const kFooter =
    "\nThe program runs once on libode8 and once for each of --threads; if something differs, up to four times more,\n"
    "to see whether it differs on libode8 as well, and in which values. Its standard input is read once and given to\n"
    "all runs (a terminal is not: programs find its end there); what it prints is kept and compared, not shown.\n"
    "Ctrl-C ends the run, and what was compared by then is told. Variables ODE_MT_... of the environment hold for the\n"
    "runs on ODE_MT, but for ODE_MT_THREADS and ODE_MT_SOLVER.\n"
    "\nExamples:\n"
    "  odemt_check -- ./simulation --frames 500\n"
    "  odemt_check --threads 0,2,auto -- /usr/bin/python3 script.py\n"
    "  odemt_check --steps 1000 -- ./simulator-that-never-ends\n"
    "\nThe exit code is 0 if all runs are equal, 1 if one differs, 2 if they could not be compared (the program makes no\n"
    "step, does not use libode.so.8, is not reproducible itself, was interrupted) or for a wrong option.\n";

std::vector<std::string> readThreads(const std::string &list) {
    std::vector<std::string> threads;
    for (const std::string &word : support::splitAtCommas(list)) {
        bench::checkThreadCount(word);
        if (std::find(threads.begin(), threads.end(), word) == threads.end()) threads.push_back(word);
    }
    if (threads.empty()) throw std::invalid_argument("--threads: no numbers given");
    return threads;
}

void checkLibraries(CheckOptions &options) {
    bench::checkLibraryFolder("--stock-library", options.stockFolder);
    bench::checkLibraryFolder("--our-library", options.ourFolder);
    const std::string stock = options.stockFolder + "/libode.so.8", ours = options.ourFolder + "/libode.so.8";
    if (bench::isOurLibrary(stock))
        throw std::invalid_argument("--stock-library: '" + stock +
                                    "' is ODE_MT, as where the package libode8-mt is installed. For Debian's: " + bench::commandsForStockLibrary());
    if (!bench::isOurLibrary(ours)) throw std::invalid_argument("--our-library: '" + ours + "' is not ODE_MT");
    options.stockRelease = bench::releaseOfLibrary(stock);
    options.ourRelease = bench::releaseOfLibrary(ours);
}

// Beside this program in a build folder, in a folder of its own beside the library in an installed tree.
std::string findObserver(const CheckOptions &options) {
    constexpr const char *kName = "libodemt_observer.so";
    const std::string beside = bench::folderOfThisProgram() + '/' + kName, installed = options.ourFolder + "/ode_mt/" + kName;
    for (const std::string &file : {beside, bench::folderOfOurLibrary() + "/ode_mt/" + kName, installed})
        if (std::filesystem::exists(file)) return file;
    throw std::invalid_argument(std::string(kName) + " is missing: neither '" + beside + "' nor '" + installed + "' exists");
}

}  // namespace

std::optional<CheckOptions> readCheckOptions(int argc, const char *const *argv, int &exitCode) {
    CheckOptions options;
    options.stockFolder = bench::folderOfStockLibrary();
    options.ourFolder = bench::folderOfOurLibrary();
    std::string threads = "0,auto";
    double seconds = 0;
    CLI::App app(kDescription, "odemt_check");
    app.footer(kFooter);
    app.add_option("--threads", threads, "threads of the runs on ODE_MT: numbers from 0 to 1024, or auto")->capture_default_str();
    app.add_option("--steps", options.steps, "end the program when a world has made this number of steps")
        ->check(bench::wholeNumberIn(1, 1'000'000'000));
    app.add_option("--seconds", seconds, "end each run after this number of seconds; steps that both runs made are compared")
        ->check(bench::numberIn(1e-3, 1e6));
    app.add_flag("--show-output", options.showOutput, "show what the program prints, on standard error, instead of comparing it");
    app.add_flag("--json", options.isJson, "print a JSON object");
    app.add_option("--stock-library", options.stockFolder, "folder of the system's libode.so.8, or of another to compare with")
        ->capture_default_str();
    app.add_option("--our-library", options.ourFolder, "folder of ODE_MT's libode.so.8")->capture_default_str();
    const auto read = [&] {
        options.command = bench::parseProgramLine(app, argc, argv);
        options.threads = readThreads(threads);
        options.limit = std::chrono::milliseconds(static_cast<long>(1000 * seconds));
        checkLibraries(options);
        options.observer = findObserver(options);
    };
    if (!bench::readCommandLine(app, read, exitCode)) return std::nullopt;
    return options;
}

}  // namespace check
