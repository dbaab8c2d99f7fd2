// Contract F3, open loop: with the user's number of iterations dWorldQuickStep of the solver fast leaves no larger residual than
// libode8's, on the same problems. A solver that keeps forces from step to step is judged on the problems that it meets, which
// libode8 solves once more; and, without such forces, on those that libode8 meets.
//
// Both norms, the largest row's velocity and the energy of all rows' errors, are root mean squares over the problems of a scene, since
// the residual of one problem is a matter of luck; one problem may have half as much again.
#include "engine_run.h"

#include "exactness/child_process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace {

using namespace quality;

// Below this any residual is rounding; m/s, and the root of J.
constexpr double kRounding = 1e-11;
// Of one problem, as a multiple of libode8's.
constexpr double kOneProblem = 1.5;

constexpr int kIterations[] = {10, 20, 50, 150};

struct Norms {
    std::vector<double> worst, energy;  // by problem; the root of the energy
};

Norms normsOf(const nlohmann::json &steps) {
    Norms norms;
    for (const auto &step : steps) {
        norms.worst.push_back(step["worst"]);
        norms.energy.push_back(std::sqrt(double(step["energy"])));
        // The velocities are those that the forces give.
        EXPECT_LE(double(step["inconsistency"]), 1e-9 * double(step["change"]) + kRounding);
    }
    return norms;
}

double meanSquareRoot(const std::vector<double> &numbers) {
    double sum = 0;
    for (const double number : numbers) sum += number * number;
    return std::sqrt(sum / static_cast<double>(numbers.size()));
}

bool isNoWorse(const std::vector<double> &judged, const std::vector<double> &reference) {
    for (std::size_t i = 0; i < judged.size(); ++i)
        if (!(judged[i] <= kOneProblem * reference[i] + kRounding)) return false;
    return meanSquareRoot(judged) <= meanSquareRoot(reference) + kRounding;
}

std::string textOf(const std::vector<double> &numbers) {
    std::ostringstream text;
    for (const double number : numbers) text << ' ' << number;
    return text.str();
}

testing::AssertionResult isNoWorse(const Norms &judged, const Norms &reference) {
    if (isNoWorse(judged.worst, reference.worst) && isNoWorse(judged.energy, reference.energy)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\nlargest row:" << textOf(judged.worst) << "\n    libode8:" << textOf(reference.worst)
                                       << "\n     energy:" << textOf(judged.energy) << "\n    libode8:" << textOf(reference.energy);
}

struct Scene {
    const char *name;
    int frames;  // before the first problem
};

std::ostream &operator<<(std::ostream &stream, const Scene &scene) { return stream << scene.name; }

constexpr Scene kScenes[] = {{"pile:200", 60}, {"stacks:4", 60},          {"wall:6", 60},   {"spheres:200", 100}, {"chain:30", 60},
                             {"ragdolls:4", 80}, {"rover:4", 60},         {"humanoids:2", 60}, {"vehicles:2", 60},
                             {"fixed_friction", 60}, {"infinite_friction", 60}, {"hard_contacts", 60}, {"shaken", 60}, {"rolling", 60},
                             {"conveyor", 60},   {"hub", 60},             {"mass_ratio", 40}, {"bouncing", 60},    {"bridge", 60}};

class OpenLoop : public testing::TestWithParam<Scene> {
protected:
    // The scene's own steps; their problems are saved.
    Norms run(const Engine &engine, int iterations) {
        return normsOf(answerOf(engine, {"run", GetParam().name, "--frames", std::to_string(GetParam().frames), "--problems", "6", "--iterations",
                                         std::to_string(iterations), "--save", m_problems})["steps"]);
    }
    // The saved problems.
    Norms replay(const Engine &engine, int iterations) {
        const nlohmann::json answer = answerOf(engine, {"replay", GetParam().name, m_problems, "--iterations", std::to_string(iterations)});
        return normsOf(answer["replays"][0]["steps"]);
    }

private:
    const exactness::TemporaryFolder m_folder;
    const std::string m_problems = m_folder.file("problems");
};

TEST_P(OpenLoop, FastIsNoWorseOnItsOwnProblems) {
    for (const int iterations : kIterations) {
        SCOPED_TRACE(iterations);
        const Norms fast = run(Engine::fast(), iterations);
        EXPECT_TRUE(isNoWorse(fast, replay(Engine::debian(), iterations)));
    }
}

TEST_P(OpenLoop, FastIsNoWorseWithoutForcesOfTheLastStep) {
    for (const int iterations : kIterations) {
        SCOPED_TRACE(iterations);
        const Norms debian = run(Engine::debian(), iterations);
        EXPECT_TRUE(isNoWorse(replay(Engine::fast(), iterations), debian));
    }
}

// What this suite would say of a solver that does half of the iterations.
TEST_P(OpenLoop, HalfOfTheIterationsAreWorse) {
    const Norms debian = run(Engine::debian(), 20);
    EXPECT_FALSE(isNoWorse(replay(Engine::debian(), 10), debian));
}

std::string nameOf(const testing::TestParamInfo<Scene> &info) {
    std::string name = info.param.name;
    for (char &letter : name)
        if (letter == ':') letter = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, OpenLoop, testing::ValuesIn(kScenes), nameOf);

}  // namespace
