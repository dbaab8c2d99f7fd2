#include "additions.h"

namespace exactness {

namespace {

Scenario::Make scene(const std::string &nameAndSize) {
    return [=](scenes::Stepper stepper) {
        return scenes::makeScene(nameAndSize + (stepper == scenes::Stepper::World ? ",world" : ",quick"));
    };
}

}  // namespace

// The scenes that bench and viewers show, small.
void addSharedScenes(Catalogue &catalogue) {
    const auto add = [&](const std::string &name, const std::string &sizeAndModifiers, const char *meaning,
                         int steps) {
        Scenario scenario{"shared_scenes/" + name, meaning, steps, scene(name + sizeAndModifiers)};
        scenario.callbacks = Scenario::Callbacks::shared;
        catalogue.push_back(scenario);
    };
    add("soccer", ":3", "three fields with robots", 60);
    add("humanoids", ":8", "eight humanoids", 40);
    add("pile", ":300", "three hundred boxes in a heap, hash space", 60);
    add("stacks", ":12,autodisable", "twelve stacks of ten boxes", 40);
    add("churn", ":60", "sixty boxes, one exchanged in every frame", 60);
    add("spheres", ":120,sap", "balls poured into a box", 120);
    add("ragdolls", ":10,quadtree", "ten ragdolls", 120);
    add("crowd", ":800,quadtree", "eight hundred boxes on the ground, quad-tree space", 40);
    add("vehicles", ":8", "buggies on a mesh", 100);
    add("vehicles_heightfield", ":8", "buggies on a height field", 100);

    add("wall", ":10", "a wall of a hundred bricks: more rows in one island than a cache holds", 30);
    catalogue.back().largeIsland = true;
    catalogue.back().callbacks = Scenario::Callbacks::reentrant;  // its pairs hang together
    catalogue.back().steppers = {scenes::Stepper::Quick};
}

}  // namespace exactness
