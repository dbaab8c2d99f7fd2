// The real-time factor of an engine once a second, as in the thesis's chapter 12.2: simulated seconds in a
// second of wall-clock time.
//
// The seconds are the engine's own: those in which other engines run do not count.
#pragma once

#include "race.h"

#include <vector>

namespace bench {

// One sample for each `period` (s) that the engine ran, at the end of the batch in which it became full; the
// rest at the end is dropped.
std::vector<double> realTimeSamples(const EngineResult &engine, double period = 1);

}  // namespace bench
