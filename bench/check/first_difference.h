// Where two runs of a program differ first.
//
// Worlds that one thread has made are paired by their numbers. All others are paired by what they did, as threads may make them in
// another order each time, and so are processes, and worlds of several processes that share tasks (a pool): those whose steps are all the same first,
// the others with the world of the same number, or else with the one that agrees with them for most steps.
#pragma once

#include <optional>

#include "check/run_record.h"

namespace check {

struct WorldPair {
    const WorldRecord *left = nullptr, *right = nullptr;  // null: only the other run has it
};

std::vector<WorldPair> pairWorlds(const RunRecord &left, const RunRecord &right);

struct FirstDifference {
    enum class Kind {
        State,    // behind this step
        LeftEnd,  // the left run has no such step
        RightEnd
    };

    Kind kind;
    std::uint64_t step;
    WorldPair worlds;
};

struct Comparison {
    std::uint64_t equalSteps = 0;  // of all worlds, each up to where it differs
    std::uint64_t worlds = 0, bodies = 0;
    std::optional<FirstDifference> first;  // with the lowest step
};

// Ends::ignored: runs that were ended from outside; only steps that both made are compared.
enum class Ends { compared, ignored };

Comparison compareRuns(const RunRecord &left, const RunRecord &right, Ends ends);

// Whether runs that differ would not if their worlds had other numbers: each world does what one of the other run does.
bool areEqualInAnotherOrder(RunRecord left, RunRecord right, Ends ends);

}  // namespace check
