// Two plays of a program, compared in all that counts, and in what is told besides.
#pragma once

#include <optional>
#include <string>

#include "check/first_difference.h"
#include "check/play.h"
#include "check/state_difference.h"

namespace check {

struct PlayComparison {
    Comparison steps;
    Ends ends = Ends::compared;           // which were compared
    std::optional<std::string> ending;    // how they end differently: "killed by …", in words
    std::optional<std::string> messages;  // of ODE's own that differ
    std::optional<std::string> output;    // what else they print differently; no difference of results

    bool isEqual() const { return !steps.first && !ending && !messages; }
};

// `lastStep`: the step behind which plays were ended, or 0.
PlayComparison comparePlays(const Play &left, const Play &right, std::uint64_t lastStep);

// The values that differ behind the step of a difference, of plays that kept its states. Empty: the plays do not differ there now.
std::optional<StateDifference> findValues(const Play &left, const Play &right, std::uint64_t step);

// "world 0", "world 0 of process 1 ('/usr/bin/x')".
std::string nameOfWorld(const Play &play, const WorldName &world);

}  // namespace check
