#include "top/top_options.h"

#include <unistd.h>

#include <cstdlib>

#include "tool_output.h"
#include "library_folders.h"
#include "command_line.h"

namespace top {

namespace {

const char *const kDescription =
    "Runs a program on ODE_MT, unchanged, and shows how its frames go, while it runs: for each world how long collision and\n"
    "step take, on how many threads, and why on one where it is one.\n"
    "\n"
    "odemt_top [OPTIONS] -- PROGRAM [ARGUMENT...]\n";

const char *const kFooter =
    "\nOn a terminal: arrow keys choose a world, q or Ctrl-C ends the program (once more: at once). What the program prints goes to\n"
    "a file, whose last lines are shown. Where standard output is no terminal a table is printed for each interval, and what the\n"
    "program prints goes to standard error. A terminal is not handed on as standard input: programs find its end there.\n"
    "\nExamples:\n"
    "  odemt_top -- ./simulation --frames 500\n"
    "  odemt_top --once --threads 2 -- /usr/bin/python3 script.py\n"
    "\nThe exit code is the program's, 128 and the number of the signal that ended it, 127 if it could not be started, 2 for a wrong\n"
    "option.\n";

// What the environment says is left as it is; else all cores.
std::string threadsOf(const std::string &option) {
    const char *const variable = std::getenv("ODE_MT_THREADS");
    if (option.empty()) return variable != nullptr && *variable != '\0' ? variable : "auto";
    bench::checkThreadCount(option);
    return option;
}

Mode modeOf(bool isOnce, bool isBatch) {
    if (isOnce) return Mode::Once;
    return isBatch || isatty(STDOUT_FILENO) == 0 ? Mode::Batch : Mode::Screen;
}

}  // namespace

std::optional<TopOptions> readTopOptions(int argc, const char *const *argv, int &exitCode) {
    TopOptions options;
    options.ourFolder = bench::folderOfOurLibrary();
    std::string threads;
    double seconds = 1;
    bool isOnce = false, isBatch = false;
    CLI::App app(kDescription, "odemt_top");
    app.footer(kFooter);
    app.add_option("--threads", threads, "threads of ODE_MT: a number from 0 to 1024, or auto (default: ODE_MT_THREADS, else auto)");
    app.add_option("--interval", seconds, "seconds between two tables")->check(bench::numberIn(0.05, 3600))->capture_default_str();
    app.add_flag("--batch", isBatch, "print a table for each interval, also on a terminal");
    app.add_flag("--once", isOnce, "print one table, when the program has ended");
    app.add_option("--output", options.output, "file for what the program prints");
    app.add_option("--our-library", options.ourFolder, "folder of ODE_MT's libode.so.8")->capture_default_str();
    const auto read = [&] {
        options.command = bench::parseProgramLine(app, argc, argv);
        options.threads = threadsOf(threads);
        options.interval = std::chrono::milliseconds(static_cast<long>(1000 * seconds));
        options.mode = modeOf(isOnce, isBatch);
        bench::checkLibraryFolder("--our-library", options.ourFolder);
    };
    if (!bench::readCommandLine(app, read, exitCode)) return std::nullopt;
    return options;
}

}  // namespace top
