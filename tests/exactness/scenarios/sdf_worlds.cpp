// The catalogue of odemt_world_scenario: sample worlds of worlds/, as the bench plays them. They are a
// program of their own, because the libraries that read SDF take longer to load than most scenarios take to
// run.
#include "catalogue.h"

#include "loader/load_world.h"

namespace exactness {

namespace {

struct SampleWorld {
    const char *name;
    const char *meaning;
    int steps;  // 200, or until what moves it does
};

constexpr SampleWorld sampleWorlds[] = {
    {"autonomous_vehicle", "a car on four suspended wheels, two of which steer, from standstill to 28 km/h", 200},
    {"bioloid", "a quadruped of 17 bodies walks among balls", 200},
    {"blimp", "thrust, drag and a righting moment on one body, among 129 static shapes", 200},
    {"create", "a robot on two wheels in a flat with furniture and a door", 200},
    {"darwin_op", "a humanoid on a table moves its head, and a ball", 200},
    {"epuck_line", "a small robot on two wheels among boxes", 200},
    {"gantry", "a crane on rails, and a stack of boxes that falls by 10 mm", 200},
    {"ghostdog", "a quadruped runs: springs as soft stops, feet that measure forces", 200},
    {"hexapod", "six legs of a hinge and a slider each walk", 200},
    {"hoap2_sumo", "a humanoid squats on a stage: feet that measure forces", 200},
    {"hoap2_walk", "a humanoid walks: feet that measure forces", 200},
    {"humanoid", "a humanoid of box feet dances", 200},
    {"ipr_factory", "two arms, and objects on a belt that moves", 200},
    {"nao_demo", "a humanoid stands and waves", 200},
    {"pioneer3at", "a robot on four wheels among 40 posts", 200},
    {"salamander", "a jointed trunk on four legs that turn walks down a ramp and swims", 3500},
    {"shrimp", "six closed loops of hinges, and a spring as a soft stop", 200},
    {"soccer", "six robots on two wheels each, and a ball", 200},
    {"sojourner", "rockers and bogies at springs, on six wheels, over a ball", 200},
    {"stewart_platform", "six closed loops of universal joints, sliders and ball joints, and boxes on them",
     200},
    {"surveyor", "ten wheels of different friction that turn on the spot", 200},
    {"uneven_terrain", "a robot on six sprung wheels, balls and boxes on a height field", 600},
    {"yamor", "a chain of modules on hinges and fixed joints crawls", 200},
    {"youbot", "rollers as a friction direction of another link, an arm with a gripper", 1100},
};

}  // namespace

const Catalogue &catalogue() {
    static const Catalogue scenarios = [] {
        Catalogue all;
        for (const SampleWorld &world : sampleWorlds) {
            const std::string name = world.name;
            // The file names the stepper.
            Scenario scenario{"sdf_worlds/" + name, world.meaning, world.steps,
                              [name](scenes::Stepper) { return worlds::loadWorld(worlds::findWorld(name)); }};
            scenario.serialBecause = "there may be one island";
            scenario.steppers = {scenes::Stepper::World};
            all.push_back(scenario);
        }
        return all;
    }();
    return scenarios;
}

}  // namespace exactness
