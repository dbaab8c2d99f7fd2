// Contract F4: the solver fast has bits of its own, and they are the same for every number of threads, every manager, schedules that are
// perturbed on purpose, every algorithm and every instruction set. Compared with one thread, every ten frames.
#include "engine_run.h"

#include "exactness/instruction_set.h"
#include "frame/sanitizers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace {

using namespace quality;

struct Scene {
    const char *name;
    bool isWorldStep;
};

std::ostream &operator<<(std::ostream &stream, const Scene &scene) { return stream << scene.name << (scene.isWorldStep ? " (dWorldStep)" : ""); }

constexpr Scene kScenes[] = {{"pile:300", false}, {"stacks:12", false},  {"wall:8", false},     {"spheres:200", false},
                             {"hub", false},      {"conveyor", false},   {"ragdolls:8", false}, {"infinite_friction", false},
                             {"rolling", false},  {"vehicles:4", false}, {"wall:5", true},      {"stacks:6", true},
                             {"pile:80", true},   {"humanoids:4", true}};

class SameBits : public testing::TestWithParam<Scene> {
protected:
    std::vector<std::string> hashes(const std::map<std::string, std::string> &variables, const std::string &instructionSet = "") const {
        std::vector<std::string> arguments{"hash", GetParam().name, "--frames", "50", "--every", "10"};
        if (GetParam().isWorldStep) arguments.push_back("--world");
        if (!instructionSet.empty()) arguments.insert(arguments.end(), {"--instruction-set", instructionSet});
        return answerOf(Engine::fast(variables), arguments)["hashes"];
    }
    std::vector<std::string> serial() const { return hashes({{"ODE_MT_THREADS", "0"}}); }
};

TEST_P(SameBits, ThreadsAndManagers) {
    const std::vector<std::string> expected = serial();
    const auto runWith = [&](int threads, const char *manager, const std::map<std::string, std::string> &more) {
        SCOPED_TRACE(std::to_string(threads) + " threads of " + manager);
        // The OpenMP runtime is not built for ThreadSanitizer, which then does not see its barriers.
        if (kThreadSanitizer && std::string(manager) == "openmp") return;
        std::map<std::string, std::string> variables{
            {"ODE_MT_THREADS", std::to_string(threads)}, {"ODE_MT_THREAD_MANAGER", manager}, {"ODE_MT_ALGORITHM", "lcp"}};
        variables.insert(more.begin(), more.end());
        EXPECT_EQ(hashes(variables), expected);
    };
    bool isOpenMP = false;
    for (const int threads : {1, 2, 3, 5, 8, 16}) {
        runWith(threads, isOpenMP ? "openmp" : "pthread", {});
        runWith(threads, isOpenMP ? "pthread" : "openmp", {{"ODE_MT_PERTURB", std::to_string(threads)}});
        isOpenMP = !isOpenMP;
    }
}

TEST_P(SameBits, InstructionSets) {
    const std::vector<std::string> expected = serial();
    for (const std::string &set : exactness::instructionSets()) {
        SCOPED_TRACE(set);
        EXPECT_EQ(hashes({{"ODE_MT_THREADS", "0"}}, set), expected);
        EXPECT_EQ(hashes({{"ODE_MT_THREADS", "2"}, {"ODE_MT_ALGORITHM", "lcp"}}, set), expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, testing::ValuesIn(kScenes), [](const testing::TestParamInfo<Scene> &info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), ':', '_');
    return name + (info.param.isWorldStep ? "_world" : "");
});

}  // namespace
