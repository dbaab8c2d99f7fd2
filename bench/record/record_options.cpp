#include "record/record_options.h"

#include <stdexcept>

#include "tool_output.h"
#include "command_line.h"
#include "world_source.h"

#include <CLI/CLI.hpp>

namespace record {

namespace {

const CLI::IsMember kAlgorithms({"original", "static", "static-unmerged", "duplication", "decluster"});

void addOptions(CLI::App &app, RecordOptions &options) {
    app.add_option("world", options.world, "SDF world, .sdf file or scene, as for odemt_bench")->required();
    app.add_option("--algorithm", options.algorithm, "which clusters are made")
        ->capture_default_str()
        ->check(kAlgorithms);
    app.add_option("--cells", options.gridCells,
                   "cells on each axis of the grid, 5 to 20; 0: tuned by measured time")
        ->capture_default_str()
        ->check(bench::wholeNumberIn(0, 20));
    app.add_option("--frames", options.frames, "frames that are run")
        ->capture_default_str()
        ->check(bench::wholeNumberIn(1, 1'000'000'000));
    app.add_option("--every", options.every, "one frame in this number is kept; the last one always")
        ->capture_default_str()
        ->check(bench::wholeNumberIn(1, 1'000'000'000));
    app.add_option("--output", options.file, "file; standard output if it is not given");
    app.add_option("--threads", options.threads,
                   "threads that step the world; which of them steps a body is recorded, too, and may differ from run to run. "
                   "0: one, which is not recorded")
        ->capture_default_str()
        ->check(bench::wholeNumberIn(0, 1024));
    app.add_flag("--contacts", options.contacts, "record contacts and their forces, too: several times as much");
    app.add_flag("--stock", options.onStock, "run Debian's libode8 instead, and record no clusters");
    app.add_flag("--ignore-unsupported", options.ignoreUnsupported,
                 "leave out elements of an SDF world that the loader does not know");
}

void check(const RecordOptions &options) {
    bench::checkWorld(options.world);
    if (options.gridCells != 0 && (options.gridCells < 5 || options.gridCells > 20))
        throw std::invalid_argument("--cells: " + std::to_string(options.gridCells) +
                                    " is not a number from 5 to 20, nor 0");
    if (options.threads != 0 && options.onStock) throw std::invalid_argument("--threads: with --stock there are none of ODE_MT's");
}

}  // namespace

std::optional<RecordOptions> readRecordOptions(int argc, const char *const *argv, int &exitCode) {
    RecordOptions options;
    CLI::App app(
        "Runs a world on ODE_MT and records the clusters and all that moves, one JSON object a line.",
        "odemt_record");
    addOptions(app, options);
    const auto read = [&] {
        app.parse(argc, argv);
        check(options);
    };
    if (!bench::readCommandLine(app, read, exitCode)) return std::nullopt;
    return options;
}

}  // namespace record
