// The command line of odemt_check.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace check {

struct CheckOptions {
    std::vector<std::string> command;    // the program and its arguments
    std::vector<std::string> threads;    // "0", "auto": of each run on ODE_MT
    std::string stockFolder, ourFolder;  // of libode.so.8
    std::string stockRelease, ourRelease;  // of ODE, in these (platform.h)
    std::string observer;                // file
    std::uint64_t steps = 0;             // of any world, after which the program is ended; 0: none
    std::chrono::milliseconds limit{0};  // of a run; 0: none
    bool isJson = false, showOutput = false;
};

constexpr int kEqual = 0, kDifferent = 1, kNotCompared = 2;  // exit codes

// Empty: the program ends with `exitCode`, as readOptions of odemt_bench.
std::optional<CheckOptions> readCheckOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace check
