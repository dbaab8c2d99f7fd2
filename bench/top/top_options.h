// The command line of odemt_top.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace top {

// Screen: a terminal is written over. Batch: a table for each interval. Once: one table, at the end.
enum class Mode { Screen, Batch, Once };

struct TopOptions {
    std::vector<std::string> command;  // the program and its arguments
    std::string threads;               // empty: as the environment says
    std::string ourFolder;             // of libode.so.8
    std::string output;                // file for what the program prints; empty: none was named
    std::chrono::milliseconds interval{1000};
    Mode mode = Mode::Screen;
};

// Empty: the program ends with `exitCode`, as readOptions of odemt_bench.
std::optional<TopOptions> readTopOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace top
