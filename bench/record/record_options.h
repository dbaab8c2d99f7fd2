// The command line of odemt_record.
#pragma once

#include <optional>
#include <string>

namespace record {

struct RecordOptions {
    std::string world;
    std::string algorithm = "decluster";
    int gridCells = 0;  // 0: tuned
    long frames = 500;  // that are run
    long every = 10;    // frames between those that are kept
    std::string file;   // empty: standard output
    int threads = 0;        // of steps; above 0: which of them has stepped a body is recorded
    bool contacts = false;  // and their forces
    bool onStock = false;   // run Debian's libode8, and record no clusters
    bool ignoreUnsupported = false;
};

// Empty: the program ends with `exitCode`, as readOptions of odemt_bench.
std::optional<RecordOptions> readRecordOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace record
