// A measured world reduced to the figures that are printed and saved.
#pragma once

#include <array>
#include <vector>

#include "race.h"
#include "serial_share.h"
#include "support/statistics.h"

namespace bench {

// The real-time factor of an engine once a second, as in the thesis's chapter 12.2: simulated seconds in a
// second of wall-clock time.
//
// The seconds are the engine's own: those in which other engines run do not count.
//
// One sample for each `period` (s) that the engine ran, at the end of the batch in which it became full; the
// rest at the end is dropped.
std::vector<double> realTimeSamples(const EngineResult &engine, double period = 1);

// OtherRelease: the first engine of another release of ODE than the reference's; those of its release are compared with it.
enum class StateCheck { Reference, Same, Differs, NotReproducible, OwnBits, OtherRelease, Unknown };
const char *nameOf(StateCheck check);

struct PartSummary {
    support::MeanAndDeviation seconds;  // per frame, over the kept running averages
    support::Spread speedUp;            // time of the first engine / own time, by rounds
};

struct EngineSummary {
    std::string engine;
    std::array<PartSummary, kParts.size()> parts;  // by Part
    double realTimeFactor = 0;                     // simulated time / wall-clock time
    double sharedSteps = 0;                        // share of steps that ours gave to several threads
    SerialWork work;                               // of ours, if it was asked for it
    unsigned messages = 0;                         // of ODE
    std::uint64_t hash = 0;                        // of the last state
    StateCheck check = StateCheck::Unknown;
    std::string failure;

    const PartSummary &part(Part which) const { return parts[static_cast<std::size_t>(which)]; }
};

std::vector<EngineSummary> summarize(const WorldResult &result);

}  // namespace bench
