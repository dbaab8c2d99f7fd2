// Judges steps and measures experiments on whatever libode.so.8 the loader finds; ODE_MT_SOLVER chooses the solver of ODE_MT. Prints
// JSON.
//
//   odemt_quality run pile:300 --frames 60 --problems 5 --save problems      steps the scene, judges some steps and saves their problems
//   odemt_quality replay pile:300 problems --iterations 20,40                steps each of them once, in a new world
//   odemt_quality measure stack towers                                       closed loop
//   odemt_quality hash pile:300 --frames 60                                  the state in the end
#include "experiment.h"
#include "judged_scenes.h"
#include "judged_step.h"
#include "observation.h"

#include "exactness/instruction_set.h"
#include "scenes/state_hash.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

namespace {

using namespace quality;
using Json = nlohmann::json;

struct Options {
    std::string scene, problems, instructionSet;
    std::vector<std::string> names;
    std::vector<int> iterations{20};
    int frames = 60, count = 1, every = 5;
    unsigned long seed = 0;
    bool isWorldStep = false, tellsVelocities = false, warmsUp = false;

    scenes::Stepper stepper() const { return isWorldStep ? scenes::Stepper::World : scenes::Stepper::Quick; }
    Stepping stepping() const { return {stepper(), iterations.front()}; }
};

std::string library() {
    Dl_info info;
    const bool isKnown = dladdr(dlsym(RTLD_DEFAULT, "dWorldStep"), &info) != 0;
    return isKnown ? info.dli_fname : "";
}

Json jsonOf(const Judgement &judgement, const Options &options) {
    Json json{{"startWorst", judgement.start.worst}, {"startEnergy", judgement.start.energy}, {"worst", judgement.residual.worst},
              {"energy", judgement.residual.energy}, {"rows", judgement.residual.rows},       {"inconsistency", judgement.inconsistency},
              {"change", judgement.change},          {"seconds", judgement.seconds}};
    if (options.tellsVelocities)
        for (const Velocity &velocity : judgement.velocities)
            for (const double number : velocity.axis) json["velocities"].push_back(number);
    return json;
}

// The problems are those of every `every`-th frame behind the first ones. Steps between them, which need no feedback, are timed.
Json runScene(const Options &options) {
    const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(options.scene, options.stepper());
    use(options.stepping(), *scene);
    JudgedScene judged(*scene);
    std::vector<SavedProblem> problems;
    Json steps = Json::array(), seconds = Json::array();
    for (int i = 0; i < options.frames; ++i) judged.frame();
    for (int i = 0; i < options.count; ++i) {
        for (int skipped = 1; skipped < options.every; ++skipped) seconds.push_back(judged.frame());
        steps.push_back(jsonOf(judged.judgedFrame(problems.emplace_back()), options));
    }
    if (!options.problems.empty()) write(problems, options.problems);
    return {{"steps", steps}, {"seconds", seconds}};
}

// A list of steps for each number of iterations.
Json replay(const Options &options) {
    const std::vector<SavedProblem> problems = readProblems(options.problems);
    Json all = Json::array();
    for (const int iterations : options.iterations) {
        Json steps = Json::array();
        for (std::size_t i = 0; i < problems.size(); ++i) {
            const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(options.scene, options.stepper());
            use({options.stepper(), iterations}, *scene);
            JudgedScene judged(*scene);
            if (options.warmsUp) judged.replay(problems[i == 0 ? problems.size() - 1 : i - 1]);
            steps.push_back(jsonOf(judged.replay(problems[i]), options));
        }
        all.push_back({{"iterations", iterations}, {"steps", steps}});
    }
    return {{"replays", all}};
}

Json measure(const Options &options) {
    Json all = Json::object();
    for (const Experiment &experiment : experiments()) {
        if (!options.names.empty() && std::find(options.names.begin(), options.names.end(), experiment.name) == options.names.end()) continue;
        dRandSetSeed(options.seed);
        for (const Quantity &quantity : experiment.run(options.stepping()))
            all[experiment.name][quantity.name] = {{"value", quantity.value},
                                                   {"unit", quantity.unit},
                                                   {"slack", quantity.slack},
                                                   {"reference", quantity.kind == Quantity::Kind::reference}};
    }
    return {{"experiments", all}};
}

Json hash(const Options &options) {
    const std::unique_ptr<scenes::Scene> scene = makeJudgedScene(options.scene, options.stepper());
    use(options.stepping(), *scene);
    std::vector<std::string> hashes;
    for (int i = 0; i < options.frames; ++i) {
        scene->frame();
        if ((i + 1) % options.every == 0) hashes.push_back(std::to_string(scenes::stateHash(scene->inventory())));
    }
    return {{"hashes", hashes}};
}

Json list() {
    Json json;
    for (const auto &scene : ownScenes()) json["scenes"][scene.name] = scene.meaning;
    for (const Experiment &experiment : experiments()) json["experiments"][experiment.name] = experiment.meaning;
    return json;
}

}  // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Judges the steps of the libode.so.8 that the loader finds.");
    app.require_subcommand(1);
    const auto command = [&](const char *name, const char *meaning) {
        CLI::App *const made = app.add_subcommand(name, meaning);
        made->add_option("--iterations", options.iterations, "of dWorldQuickStep (20)")->delimiter(',')->check(CLI::PositiveNumber);
        made->add_flag("--world", options.isWorldStep, "dWorldStep, not dWorldQuickStep");
        made->add_option("--instruction-set", options.instructionSet, "that ODE_MT's vector code uses, as in AVX2");
        return made;
    };
    CLI::App *const runs = command("run", "step a scene, and judge some steps");
    runs->add_option("--save", options.problems, "file for the problems");
    runs->add_option("--problems", options.count, "how many steps are judged (1)");
    CLI::App *const replays = command("replay", "step saved problems");
    CLI::App *const measures = command("measure", "closed loop");
    measures->add_option("experiments", options.names, "all unless named");
    measures->add_option("--seed", options.seed, "of dRand, which dWorldQuickStep draws its orders from (0)");
    CLI::App *const hashes = command("hash", "the state after each --every frames");
    for (CLI::App *const made : {runs, replays, hashes}) made->add_option("scene", options.scene)->required();
    replays->add_option("problems", options.problems)->required();
    replays->add_flag("--warm-up", options.warmsUp, "step another of the problems before, so that memory is there");
    for (CLI::App *const made : {runs, replays}) made->add_flag("--velocities", options.tellsVelocities, "tell all velocities after each step");
    for (CLI::App *const made : {runs, hashes}) {
        made->add_option("--frames", options.frames, "frames before (60)");
        made->add_option("--every", options.every, "frames from one to the next (5)")->check(CLI::PositiveNumber);
    }
    app.add_subcommand("list", "scenes and experiments");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!options.instructionSet.empty()) exactness::forceInstructionSet(options.instructionSet);
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        Json answer = runs->parsed() ? runScene(options) : replays->parsed() ? replay(options) : measures->parsed() ? measure(options)
                      : hashes->parsed() ? hash(options) : list();
        answer["library"] = library();
        answer["instructionSet"] = exactness::instructionSetInUse();
        std::cout << answer.dump() << '\n';
        dCloseODE();
        return 0;
    } catch (const std::exception &error) {
        std::cerr << "odemt_quality: " << error.what() << '\n';
        return 2;
    }
}
