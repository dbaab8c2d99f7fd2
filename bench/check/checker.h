// odemt_check's verdict: plays on both libraries, compared.
//
//   1. once on libode8, once on ODE_MT for each number of threads
//   2. where something differs, several rounds of one more play on each; all keep the states behind the step in question
//
// A program that differs from itself on libode8, in any round, proves nothing. One that has two ways at random takes the same one in
// all plays on libode8 and the other one in all on ODE_MT with a probability of 4 to the power of minus the plays on each, at most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/check_options.h"
#include "check/first_difference.h"
#include "check/play.h"
#include "check/state_difference.h"

namespace check {

// One play in figures.
struct EngineResult {
    std::string name, library, release, ending;
    double seconds = 0, cpuSeconds = 0, stepSeconds = 0, observerSeconds = 0;
    std::uint64_t steps = 0;
    std::string result;  // "equal", "differs at step 38"; empty for libode8
};

// What differs, as far as it was found out.
struct Finding {
    std::string engine;  // "ODE_MT, 2 threads"; "libode8" of a program that differs from itself
    std::uint64_t step = 0;
    std::string world;  // "world 0", "world 0 of process 1"
    std::optional<StateDifference> state;
};

struct CheckResult {
    enum class Verdict { Equal, Different, NotCompared };

    Verdict verdict = Verdict::NotCompared;
    std::string sentence;
    std::vector<std::string> remarks;  // sentences
    std::optional<Finding> finding;
    std::vector<EngineResult> engines;                // libode8 first
    std::uint64_t steps = 0, worlds = 0, bodies = 0;  // that were compared, on each engine
};

CheckResult check(const CheckOptions &options);

}  // namespace check
