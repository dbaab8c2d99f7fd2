// Runs one scenario on whatever libode.so.8 the loader finds, and writes a record of it.
//
//   LD_LIBRARY_PATH=build/lib ODE_MT_THREADS=2 odemt_scenario ball_joints/quick --record ours.json
#include "engine_statistics.h"
#include "instruction_set.h"
#include "recorder.h"
#include "scenarios/catalogue.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace {

using namespace exactness;

struct Options {
    std::string scenario;
    std::string recordPath;
    int steps = 0;  // 0: as many as the scenario says
    int dumpStep = Recorder::noStep;
    unsigned timeLimit = 0;  // s, 0: none
    bool list = false;
    bool fields = false;
    bool unordered = false;
    std::string instructionSet;  // empty: the widest
};

const char *suffix(scenes::Stepper stepper) {
    return stepper == scenes::Stepper::World ? "/world" : "/quick";
}

const char *nameOf(Scenario::Callbacks callbacks) {
    switch (callbacks) {
    case Scenario::Callbacks::reentrant: return "reentrant";
    case Scenario::Callbacks::shared: return "shared";
    default: return "";
    }
}

// One line for each scenario and stepper: name, whether it is serial and why, whether its callbacks may run
// concurrently, whether it is a large island, meaning; separated by tabs.
void list() {
    for (const Scenario &scenario : catalogue()) {
        for (scenes::Stepper stepper : scenario.steppers) {
            std::cout << scenario.name << suffix(stepper) << '\t' << scenario.serialBecause << '\t'
                      << nameOf(scenario.callbacks) << '\t' << (scenario.largeIsland ? "team" : "") << '\t'
                      << scenario.meaning << '\n';
        }
    }
}

struct Choice {
    const Scenario &scenario;
    scenes::Stepper stepper;
};

Choice choose(const std::string &name) {
    for (const Scenario &scenario : catalogue()) {
        for (scenes::Stepper stepper : scenario.steppers) {
            if (name == scenario.name + suffix(stepper)) return {scenario, stepper};
        }
    }
    throw std::invalid_argument("no scenario '" + name + "'; --list shows all");
}

Record run(const Choice &choice, const Options &options) {
    const int steps = options.steps > 0 ? options.steps : choice.scenario.steps;
    std::unique_ptr<scenes::Scene> scene = choice.scenario.make(choice.stepper);
    Recorder recorder(*scene, options.dumpStep, options.unordered ? Recorder::Order::ignored : Recorder::Order::kept);
    scene->observe(&recorder);
    recorder.endStage("start");
    for (int step = 1; step <= steps; ++step) {
        recorder.beginStep(step);
        scene->control();
        scene->collide();
        recorder.endStage("collide");
        scene->step();
        recorder.endStage("step");
        scene->finish();
    }
    recorder.endStage("end");
    std::cout << steps << " steps; " << recorder.summary() << '\n';
    scene->observe(nullptr);
    if (choice.scenario.leavesRuins) scene.release();
    return recorder.take(runningEngine());
}

int main(const Options &options) {
    if (options.list) {
        list();
        return 0;
    }
    if (options.fields) {
        for (const std::string &line : describeFields()) std::cout << line << '\n';
        return 0;
    }
    if (!options.instructionSet.empty()) forceInstructionSet(options.instructionSet);
    alarm(options.timeLimit);  // a step that never ends is a failure too
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    const Choice choice = choose(options.scenario);
    const Record record = run(choice, options);
    if (!choice.scenario.leavesRuins) dCloseODE();
    if (!options.recordPath.empty()) record.write(options.recordPath);
    std::cout.flush();
    if (choice.scenario.leavesRuins) std::_Exit(0);
    return 0;
}

}  // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Runs one scenario of the exactness suite on the libode.so.8 that the loader finds.");
    auto *scenario =
        app.add_option("scenario", options.scenario, "name and stepper, as in ball_joints/quick");
    app.add_option("--record", options.recordPath, "file for the record (JSON)");
    app.add_option("--steps", options.steps, "number of steps, else the scenario's own")
        ->check(CLI::PositiveNumber);
    app.add_option("--dump-step", options.dumpStep, "record every value of this step")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--time-limit", options.timeLimit, "end the program after this number of seconds");
    app.add_flag("--unordered", options.unordered, "record near pairs and contacts without their order");
    app.add_option("--instruction-set", options.instructionSet, "that ODE_MT's vector code uses, as in AVX2");
    app.add_flag("--list", options.list, "show all scenarios")->excludes(scenario);
    app.add_flag("--list-fields", options.fields, "show all fields that are compared")->excludes(scenario);
    CLI11_PARSE(app, argc, argv);
    try {
        return main(options);
    } catch (const std::exception &error) {
        std::cerr << "odemt_scenario: " << error.what() << '\n';
        return 2;
    }
}
