// Results as text for people and as files for programs.
#pragma once

#include "race.h"

#include <string>
#include <vector>

namespace bench {

// What was run, and the table of its engines.
std::string reportText(const WorldResult &result);

// For each world of several sizes: time over size, and the exponent of its growth. Empty if there are none.
std::string reportCurves(const std::vector<WorldResult> &results);

// For each kind of ours with several numbers of threads: the speed-ups of all worlds over the number of threads. Empty
// if there are none.
std::string reportScaling(const std::vector<WorldResult> &results);

// One sentence for all worlds: how fast the fastest engine of ours is, and whether all results are the same. Empty if none
// of ours was compared.
std::string reportSentence(const std::vector<WorldResult> &results);

// Everything, the machine and the libraries' files included; the kept running averages, which are most of it,
// if asked for.
std::string reportJson(const std::vector<WorldResult> &results, bool withAverages = true);

// One line for each world and engine; with worlds of several sizes, size and growth at its end.
std::string reportCsv(const std::vector<WorldResult> &results);

// One line for each second that each engine ran: its real-time factor.
std::string reportSamples(const std::vector<WorldResult> &results);

}  // namespace bench
