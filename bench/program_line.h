// The command line of a tool that runs a program: TOOL [OPTIONS] -- PROGRAM [ARGUMENT...].
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bench {

// Reads the options before the dashes by `app`, which has the tool's name. Returns the program and its arguments. Throws CLI::ParseError, or
// std::invalid_argument if there is no program.
std::vector<std::string> parseProgramLine(CLI::App &app, int argc, const char *const *argv);

// Throws std::invalid_argument unless an option --threads may be `word`.
void checkThreadCount(const std::string &word);

}  // namespace bench
