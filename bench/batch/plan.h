// What odemt_batch is asked to run: a JSON file, docs/tools.md has an example.
//
// A run is one world with one value of each parameter and one seed. Runs are numbered by the plan alone: worlds first, then values of
// parameters, the last one named changing fastest, then seeds. Reading is strict: a key or value that is not known is an error that names it.
#pragma once

#include "batch/observable.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace batch {

using Json = nlohmann::ordered_json;

// Values are numbers, texts, true or false.
struct Parameter {
    std::string name;
    std::vector<Json> values;
};

struct Run {
    long number;
    std::string world;                                // as for odemt_bench
    std::vector<std::pair<std::string, Json>> values;  // of the parameters, in their order
    std::uint32_t seed;
};

// What a seed moves, beside the random sequence of ODE. Units: m, m/s.
struct Perturbation {
    double position = 0, velocity = 0;  // at most, on each axis
};

struct Plan {
    static constexpr long kMaxFrames = 1'000'000'000;  // of a run

    std::vector<std::string> worlds;
    std::vector<Parameter> parameters;
    bool isGrid = true;  // else the n-th values of all parameters belong together
    std::vector<std::uint32_t> seeds;
    long frames = 0;
    double seconds = 0;  // simulated; 0: frames says how many
    Perturbation perturbation;
    std::vector<Observable> observables;
    std::vector<Observable> series;  // a row of them after each `every`-th frame
    long every = 0;                  // 0: no series
    bool hasStates = false;          // and rows of all bodies with it
    bool ignoreUnsupported = false;
    std::string text;         // of the whole plan, in one spelling
    std::string fingerprint;  // of that and of the files of its worlds

    long combinations() const;  // of values of parameters
    long count() const;         // of runs
    Run run(long number) const;
};

// Throws std::invalid_argument.
Plan readPlan(const std::string &text);

}  // namespace batch
