// The scenarios: scenes made for one thing that must come out exactly as upstream's.
#pragma once

#include "scenes/scene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace exactness {

struct Scenario {
    using Make = std::function<std::unique_ptr<scenes::Scene>(scenes::Stepper)>;

    std::string name;     // that of its file, with more behind it if the file has several
    std::string meaning;  // one line
    int steps;
    Make make;
    // Why its islands cannot run in parallel; empty: they can, and the suite asserts that they do.
    std::string serialBecause = "";
    std::vector<scenes::Stepper> steppers = {scenes::Stepper::World, scenes::Stepper::Quick};
    // It leaves a step or a space half way, after which upstream cannot destroy what there is: the program
    // ends at once, without doing so.
    bool leavesRuins = false;
    // May its near-callbacks run on several threads at once, for they write to nothing of their pairs? And do its
    // pairs fall into sets that share no body, in a space whose pairs are found in parallel, so that they do?
    enum class Callbacks { oneAtATime, reentrant, shared };
    Callbacks callbacks = Callbacks::oneAtATime;
    // One island is so large that several workers step it together, and the suite asserts that they do.
    bool largeIsland = false;
};

// Makes a scene whose constructor takes the stepper and `arguments`.
template <class Scene, class... Arguments>
Scenario::Make make(Arguments... arguments) {
    return [=](scenes::Stepper stepper) { return std::make_unique<Scene>(stepper, arguments...); };
}

// A scenario about collisions alone, where what the stepper makes of the contacts is no matter.
Scenario collisionScenario(std::string name, std::string meaning, int steps, Scenario::Make make,
                           Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime);

// A scenario about one island that several workers step together.
Scenario teamScenario(std::string name, std::string meaning, int steps, Scenario::Make make,
                      scenes::Stepper stepper = scenes::Stepper::Quick);

using Catalogue = std::vector<Scenario>;
const Catalogue &catalogue();

}  // namespace exactness
