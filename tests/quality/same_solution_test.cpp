// Contract F2: dWorldStep of the solver fast gives bodies the velocities that libode8's gives them, on problems that libode8's run meets,
// to nine digits of the largest change; and where the residual can be told from outside (limits of friction that do not hang on the
// normals' forces of another problem), it is no larger than libode8's or than rounding.
#include "engine_run.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace {

using namespace quality;

struct Scene {
    const char *name;
    bool hasJudgedResidual;
};

std::ostream &operator<<(std::ostream &stream, const Scene &scene) { return stream << scene.name; }

constexpr Scene kScenes[] = {{"wall:5", false},      {"pile:60", false},    {"stacks:2", false},   {"spheres:60", false}, {"chain:250", true},
                             {"humanoids:2", false}, {"ragdolls:3", false}, {"vehicles:2", false}, {"rover:4", false},    {"fixed_friction", true},
                             {"conveyor", false},    {"rolling", false},    {"mass_ratio", false}, {"bouncing", false},   {"bridge", false}};

class SameSolution : public testing::TestWithParam<Scene> {};

// Frames before are QuickSteps of libode8.
TEST_P(SameSolution, VelocitiesAreLibode8s) {
    const support::TemporaryFolder folder;
    const std::string problems = folder.file("problems"), name = GetParam().name;
    answerOf(Engine::debian(), {"run", name, "--frames", "60", "--problems", "3", "--save", problems});
    const auto solutions = [&](const Engine &engine) {
        return answerOf(engine, {"replay", name, problems, "--world", "--velocities"})["replays"][0]["steps"];
    };
    const auto debian = solutions(Engine::debian()), fast = solutions(Engine::fast());
    ASSERT_EQ(fast.size(), debian.size());
    for (std::size_t i = 0; i < fast.size(); ++i) {
        const std::vector<double> ours = fast[i]["velocities"], theirs = debian[i]["velocities"];
        ASSERT_EQ(ours.size(), theirs.size());
        double difference = 0;
        for (std::size_t k = 0; k < ours.size(); ++k) difference = std::max(difference, std::fabs(ours[k] - theirs[k]));
        const double change = debian[i]["change"];
        EXPECT_LE(difference, 1e-9 * change) << "of " << change << " in step " << i;
        EXPECT_LE(double(fast[i]["inconsistency"]), 1e-9 * change);
        if (GetParam().hasJudgedResidual) {
            EXPECT_LE(double(fast[i]["worst"]), std::max(double(debian[i]["worst"]), 1e-11));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameSolution, testing::ValuesIn(kScenes), [](const testing::TestParamInfo<Scene> &info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), ':', '_');
    return name;
});

}  // namespace
