// What the programs say when they end with an error.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace bench {

constexpr int kWrongOption = 2;  // exit code

// A line on standard error, with control characters as \x1b: names and values may hold anything.
void printError(const std::string &message);

// The same for an option, with a second line that refers to --help. Returns kWrongOption.
int printOptionError(const std::string &message);

// Calls `read`, which parses a command line by `app` and throws where it is wrong, and prints what that says. Returns false if the program
// ends with `exitCode`: 0 for --help.
bool readCommandLine(const CLI::App &app, const std::function<void()> &read, int &exitCode);

}  // namespace bench
