// Contract F3, open loop: with the user's number of iterations dWorldQuickStep of the solver fast leaves no larger residual than
// libode8's, on the same problems. A solver that keeps forces from step to step is judged on the problems that it meets, which
// libode8 solves once more; and, without such forces, on those that libode8 meets.
//
// The energy of all rows' errors is compared, problem by problem: the geometric mean of the ratios is 1 at most, but for noise. Its largest row is
// one of hundreds, and a matter of luck: with three times the iterations it is still larger now and then.
//
// Covers dxContactReader.cpp, dxRowConstraints.cpp.
#include "engine_run.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

namespace {

using namespace quality;

// Of the residual of no forces at all: less is not compared. A millionth of a fall's velocity in a step is 0.1 um/s.
constexpr double kNegligible = 1e-6;
constexpr double kRounding = 1e-11;  // m/s
// Of geometric means of ratios to libode8's residuals. Residuals do not fall steadily: in the bridge libode8 itself leaves up to two percent
// more with twice the iterations. With nine tenths of them it fails in most scenes.
struct Limits {
    double energy = 1.05, largestRow = 1.5;
};
constexpr double kOneProblem = 10;  // of the largest energies of a scene

// Where the contract does not hold: with another number of iterations than the default, 20, or in the first steps of a world. Limits are about
// a tenth above what was measured.
struct Exception {
    const char *scene;
    bool isCold;
    int iterations;
    Limits limits;
};
constexpr Exception kExceptions[] = {
    {"heavy_deck", false, 10, {1.25, 1.5}}, {"pile:200", true, 50, {1.35, 1.65}},       {"stacks:4", true, 150, {1.4, 1.5}},
    {"wall:6", true, 50, {1.5, 1.6}},       {"rover:4", true, 50, {1.1, 1.7}},          {"conveyor", true, 10, {1.45, 1.5}},
    {"conveyor", true, 20, {1.55, 1.6}},    {"fixed_friction", true, 50, {1.55, 1.6}}, {"infinite_friction", true, 50, {1.2, 1.1}},
    {"bouncing", true, 150, {1.25, 1.3}},   {"net", true, 150, {1.05, 1.9}}};

Limits limitsOf(const std::string &scene, bool isCold, int iterations) {
    for (const Exception &exception : kExceptions)
        if (scene == exception.scene && isCold == exception.isCold && iterations == exception.iterations) return exception.limits;
    return {};
}

constexpr int kIterations[] = {10, 20, 50, 150};

// By problem. Energies are roots.
struct Norms {
    std::vector<double> worst, energy, startWorst, startEnergy;
};

Norms normsOf(const nlohmann::json &steps) {
    Norms norms;
    for (const auto &step : steps) {
        norms.worst.push_back(step["worst"]);
        norms.energy.push_back(std::sqrt(double(step["energy"])));
        norms.startWorst.push_back(step["startWorst"]);
        norms.startEnergy.push_back(std::sqrt(double(step["startEnergy"])));
        // The velocities are those that the forces give.
        EXPECT_LE(double(step["inconsistency"]), 1e-9 * double(step["change"]) + kRounding);
    }
    return norms;
}

std::vector<double> ratiosOf(const std::vector<double> &judged, const std::vector<double> &reference, const std::vector<double> &start) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < judged.size(); ++i) {
        const double least = kNegligible * start[i] + kRounding;
        ratios.push_back(std::max(judged[i], least) / std::max(reference[i], least));
    }
    return ratios;
}

double geometricMean(const std::vector<double> &numbers) {
    double sum = 0;
    for (const double number : numbers) sum += std::log(number);
    return std::exp(sum / static_cast<double>(numbers.size()));
}

std::string textOf(const std::vector<double> &numbers) {
    std::ostringstream text;
    for (const double number : numbers) text << ' ' << number;
    return text.str();
}

testing::AssertionResult isNoWorse(const Norms &judged, const Norms &reference, const Limits &limits = {}) {
    const std::vector<double> energy = ratiosOf(judged.energy, reference.energy, reference.startEnergy);
    const std::vector<double> worst = ratiosOf(judged.worst, reference.worst, reference.startWorst);
    const double largest = *std::max_element(judged.energy.begin(), judged.energy.end());
    const double usual = *std::max_element(reference.energy.begin(), reference.energy.end());
    if (geometricMean(energy) <= limits.energy && geometricMean(worst) <= limits.largestRow &&
        largest <= std::max(kOneProblem * usual, kNegligible * reference.startEnergy[0]))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "energy " << geometricMean(energy) << " times that of libode8:" << textOf(energy)
                                       << "\nlargest row " << geometricMean(worst) << " times:" << textOf(worst)
                                       << "\n     energy:" << textOf(judged.energy) << "\n    libode8:" << textOf(reference.energy)
                                       << "\nlargest row:" << textOf(judged.worst) << "\n    libode8:" << textOf(reference.worst);
}

struct Scene {
    const char *name;
    int frames;           // before the first problem
    int enough = 20;      // iterations that half of them are worse than; more where residuals fall slowly
    int problems = 10;    // more where they differ: of bouncing balls the ratio of residuals is 0.03 to 10
};

std::ostream &operator<<(std::ostream &stream, const Scene &scene) { return stream << scene.name; }

constexpr Scene kScenes[] = {{"pile:200", 60},
                             {"stacks:4", 60},
                             {"wall:6", 60},
                             {"spheres:200", 100},
                             {"chain:30", 60},
                             {"ragdolls:4", 80},
                             {"rover:4", 60},
                             {"humanoids:2", 60},
                             {"vehicles:2", 60},
                             {"fixed_friction", 60},
                             {"infinite_friction", 60},
                             {"hard_contacts", 60},
                             {"shaken", 60},
                             {"rolling", 60},
                             {"conveyor", 60},
                             {"hub", 60},
                             {"deck", 20},
                             {"heavy_deck", 20},
                             {"mass_ratio", 40, 400},
                             {"bouncing", 60, 20, 100},
                             {"bridge", 60, 400},
                             {"joint_grid:40", 40, 400},
                             {"net", 100}};

class OpenLoop : public testing::TestWithParam<Scene> {
protected:
    // The scene's own steps; their problems are saved.
    Norms run(const Engine &engine, int iterations) {
        const Scene &scene = GetParam();
        return normsOf(answerOf(engine, {"run", scene.name, "--frames", std::to_string(scene.frames), "--problems", std::to_string(scene.problems),
                                         "--iterations", std::to_string(iterations), "--save", m_problems})["steps"]);
    }
    // The saved problems.
    Norms replay(const Engine &engine, int iterations) {
        const nlohmann::json answer = answerOf(engine, {"replay", GetParam().name, m_problems, "--iterations", std::to_string(iterations)});
        return normsOf(answer["replays"][0]["steps"]);
    }

private:
    const support::TemporaryFolder m_folder;
    const std::string m_problems = m_folder.file("problems");
};

TEST_P(OpenLoop, FastIsNoWorseOnItsOwnProblems) {
    for (const int iterations : kIterations) {
        SCOPED_TRACE(iterations);
        const Norms fast = run(Engine::fast(), iterations);
        EXPECT_TRUE(isNoWorse(fast, replay(Engine::debian(), iterations), limitsOf(GetParam().name, false, iterations)));
    }
}

TEST_P(OpenLoop, FastIsNoWorseWithoutForcesOfTheLastStep) {
    for (const int iterations : kIterations) {
        SCOPED_TRACE(iterations);
        const Norms debian = run(Engine::debian(), iterations);
        EXPECT_TRUE(isNoWorse(replay(Engine::fast(), iterations), debian, limitsOf(GetParam().name, true, iterations)));
    }
}

// What this suite would say of a solver that does half of the iterations.
TEST_P(OpenLoop, HalfOfTheIterationsAreWorse) {
    const Norms debian = run(Engine::debian(), GetParam().enough);
    EXPECT_FALSE(isNoWorse(replay(Engine::debian(), GetParam().enough / 2), debian));
}

std::string nameOf(const testing::TestParamInfo<Scene> &info) {
    std::string name = info.param.name;
    for (char &letter : name)
        if (letter == ':') letter = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, OpenLoop, testing::ValuesIn(kScenes), nameOf);

}  // namespace
