// A measured world reduced to the figures that are printed and saved.
#pragma once

#include "race.h"
#include "support/statistics.h"

#include <array>

namespace bench {

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
    unsigned messages = 0;                         // of ODE
    std::uint64_t hash = 0;                        // of the last state
    StateCheck check = StateCheck::Unknown;
    std::string failure;

    const PartSummary &part(Part which) const { return parts[static_cast<std::size_t>(which)]; }
};

std::vector<EngineSummary> summarize(const WorldResult &result);

}  // namespace bench
