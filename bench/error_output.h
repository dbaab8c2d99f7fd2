// What the programs say when they end with an error.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace bench {

constexpr int kWrongOption = 2;  // exit code

// A line on standard error, with control characters as \x1b: names and values may hold anything.
void printError(const std::string &message);

// The same for an option, with a second line that refers to --help. Returns kWrongOption.
int printOptionError(const std::string &message);

// Prints what the parser ended with. Returns the exit code: 0 for --help.
int exitCodeOf(const CLI::App &app, const CLI::ParseError &error);

}  // namespace bench
