// The command line of odemt_bench.
#pragma once

#include "competitor.h"
#include "race.h"

#include <optional>
#include <string>
#include <vector>

namespace bench {

struct Options {
    std::vector<std::string> worlds;
    std::vector<Engine> engines;
    RaceSettings race;
    ChildSettings child;
    std::string jsonFile, csvFile;
    std::string samplesFile;   // empty: none is written
    std::string htmlFile;      // empty: none is written
    std::string traceFile;     // of ours, what each thread does; empty: none is written
    bool withAverages = true;  // in the JSON file
    bool list = false;         // print the worlds and end
    std::vector<std::string> compared;  // two files of results: compare them and end; empty: measure
};

// Empty: the program ends with `exitCode` (help was asked for or an option was wrong; what there is to
// say has been said on standard output or standard error).
std::optional<Options> readOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace bench
