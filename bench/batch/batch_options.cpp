#include "batch/batch_options.h"

#include "tool_output.h"
#include "platform.h"
#include "command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace batch {

std::optional<BatchOptions> readBatchOptions(int argc, const char *const *argv, int &exitCode) {
    BatchOptions options;
    CLI::App app("Runs the worlds of a plan, and writes what comes out into an SQLite file, one row a run.", "odemt_batch");
    app.add_option("plan", options.planFile, "JSON file (docs/tools.md)")->required();
    app.add_option("-o,--output", options.output, "SQLite file; the plan's name with .sqlite if it is not given");
    app.add_option("-j,--workers,--threads", options.workers,
                   "worlds that run at the same time, on each rank of MPI; 0: one for each processor that the process may use")
        ->capture_default_str()
        ->check(bench::wholeNumberIn(0, 1024));
    app.add_flag("--resume", options.isResumed, "go on with the output of a batch that has ended early, if there is one");
    app.add_flag("--list", options.lists, "print the runs, one JSON object a line, and run nothing");
    app.add_flag("--quiet", options.isQuiet, "say nothing while it runs");
    if (!bench::readCommandLine(app, [&] { app.parse(argc, argv); }, exitCode)) return std::nullopt;
    if (options.output.empty()) options.output = std::filesystem::path(options.planFile).replace_extension(".sqlite").string();
    if (options.workers == 0) options.workers = std::max(1u, bench::thisMachine().cores);
    return options;
}

}  // namespace batch
