// Closed loop: scenes that are stepped for some seconds, and what may be said of how they end. One experiment measures several
// quantities.
#pragma once

#include "scenes/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace quality {

struct Quantity {
    enum class Kind {
        error,     // 0 is right, and more is worse
        reference  // right is what libode8's dWorldStep gives
    };

    std::string name;
    std::string unit;
    double value;
    double slack;  // that no user notices, in the unit
    Kind kind = Kind::error;
};

// What the stepper of the experiment's world is, and its iterations.
struct Stepping {
    scenes::Stepper stepper = scenes::Stepper::Quick;
    int iterations = 20;
};

struct Experiment {
    std::string name, meaning;
    std::function<std::vector<Quantity>(const Stepping &)> run;
};

const std::vector<Experiment> &experiments();

// The files' own, which experiments() joins.
std::vector<Experiment> restingExperiments(), masonryExperiments(), slidingExperiments(), jointExperiments(), movingExperiments();

}  // namespace quality
