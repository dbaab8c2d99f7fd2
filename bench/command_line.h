// Checks of numeric options, and command lines of tools that run a program.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bench {

// Checks of numeric options: one rule for all, and a message that names the range as a person would write it.
//
// A number is what std::from_chars reads of the whole word: no NaN, no infinity, no overflow, nothing behind it.
CLI::Validator numberIn(double least, double most);
CLI::Validator wholeNumberIn(long least, long most);

// The command line of a tool that runs a program: TOOL [OPTIONS] -- PROGRAM [ARGUMENT...].
//
// Reads the options before the dashes by `app`, which has the tool's name. Returns the program and its arguments. Throws CLI::ParseError, or
// std::invalid_argument if there is no program.
std::vector<std::string> parseProgramLine(CLI::App &app, int argc, const char *const *argv);

// Throws std::invalid_argument unless an option --threads may be `word`.
void checkThreadCount(const std::string &word);

}  // namespace bench
