// Results as text for people and as files for programs.
#pragma once

#include "race.h"

#include <string>
#include <vector>

namespace bench {

// What was run, and the table of its engines.
std::string reportText(const WorldResult &result);

// Everything, the kept running averages and the libraries' files included.
std::string reportJson(const std::vector<WorldResult> &results);

// One line for each world and engine.
std::string reportCsv(const std::vector<WorldResult> &results);

}  // namespace bench
