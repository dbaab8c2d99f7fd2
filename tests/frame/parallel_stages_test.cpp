// Each parallel stage is run by at least two workers: one that always runs on a single worker
// would never be tested for what workers do to one another.
//
// Covers dxBodyMotion.cpp, dxLargeIslandStep.cpp, dxSpaceCollision.cpp, dxWorkersRunner.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <chrono>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "ChainWorld.h"
#include "HeapWorld.h"
#include "OdeSession.h"
#include "PackedWorld.h"
#include "SphereRows.h"
#include "../dynamics/joint_world.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxParallelStage.h"
#include "threading/dxSchedulePoints.h"
#include "threading/dxTaskRunner.h"

namespace {

using Stage = dxParallelStage;

// What is played until two workers have run each of its stages.
struct Scene {
    const char *name;
    void (*play)();
    std::vector<Stage> stages;  // that it has
};

// gtest calls this to name a scene.
[[maybe_unused]] void PrintTo(const Scene &scene, std::ostream *out) { *out << scene.name; }

void playChains() { ChainWorld(64, 8).step(3); }

void playWorlds() {
    std::vector<std::unique_ptr<ChainWorld>> chains;
    std::vector<dWorldID> worlds;
    for (int i = 0; i < 100; ++i) {
        chains.push_back(std::make_unique<ChainWorld>(2, 3));
        worlds.push_back(chains.back()->world());
    }
    for (int frame = 0; frame < 3; ++frame) dODE_MT_StepWorlds(worlds.data(), 100, "quick", REAL(0.01));
}

void playHeap() {
    HeapWorld heap(dHashSpaceCreate(nullptr));
    for (int frame = 0; frame < 3; ++frame) {
        heap.collide();
        heap.step();
    }
}

void playCallbacks() {
    dODE_MT_SetCallbackPolicy("concurrent");
    SphereRows rows(dHashSpaceCreate(nullptr));
    dSpaceCollide(rows.space(), nullptr, [](void *, dGeomID o1, dGeomID o2) {
        dContactGeom contact;
        dCollide(o1, o2, 1, &contact, sizeof contact);
    });
    dODE_MT_SetCallbackPolicy("serial");
}

// One island: two layers of boxes.
void playPacked(int columns, int rows, dWorldStepFunction *stepper, const char *solver = "exact") {
    PackedWorld boxes(columns, rows, 2, stepper);
    dODE_MT_SetSolver(boxes.world(), solver);
    for (int frame = 0; frame < 2; ++frame) boxes.frame();
}

// One island.
void playNet() {
    JointWorld net("fast");
    net.addNet(30);
    for (int frame = 0; frame < 2; ++frame) dWorldStep(net.world(), dReal(0.01));
}

const Scene kScenes[] = {
    {"Chains", playChains, {Stage::IslandSurvey, Stage::Islands}},
    {"Worlds", playWorlds, {Stage::WorldSurvey, Stage::WorldPreparation, Stage::Worlds}},
    {"Heap",
     playHeap,
     {Stage::Boxes, Stage::CellGridPairs, Stage::VerletChanges, Stage::VerletCandidates}},
    {"Callbacks", playCallbacks, {Stage::Callbacks}},
    {"LargeIsland",
     [] { playPacked(10, 10, dWorldQuickStep); },
     {Stage::PairKeys, Stage::KeptPairKeys, Stage::NarrowphasePrefetch, Stage::Bodies, Stage::Joints, Stage::RightHandSides,
      Stage::Rows, Stage::SorPlan, Stage::SorSweep, Stage::Motion}},
    {"LargeIslandOfAFastWorld", [] { playPacked(24, 24, dWorldQuickStep, "fast"); }, {Stage::PgsSweep}},
    {"LargeIslandInBodySpace", [] { playPacked(16, 16, dWorldStep, "fast"); }, {Stage::BodySpace}},
    {"LargeIslandOfJoints", playNet, {Stage::Fronts}},
    // In a row, so that each box touches few others and the factor has zeros to skip.
    {"LargeExactIsland",
     [] { playPacked(16, 1, dWorldStep); },
     {Stage::PanelSolve, Stage::TransposedSolve, Stage::SparseProducts}},
};

// Names of the scene's stages that two workers have not run yet.
std::string missing(const Scene &scene) {
    std::string names;
    for (const Stage stage : scene.stages)
        if (!dxParallelStages::ranByTwo(stage))
            names += (names.empty() ? "" : ", ") + std::string(dxParallelStages::kNames[static_cast<std::size_t>(stage)]);
    return names;
}

const std::thread::id caller = std::this_thread::get_id();

// The caller pauses before each block, so that workers arrive in time on a busy machine, too.
class HesitatingCaller {
public:
    HesitatingCaller() {
        dxSetPerturbation([](auto...) {
            if (std::this_thread::get_id() == caller) std::this_thread::sleep_for(std::chrono::microseconds(100));
        });
    }
    ~HesitatingCaller() { dxSetPerturbation(nullptr); }
};

class ParallelStages : public testing::TestWithParam<Scene> {};

// A worker that comes late nevertheless finds nothing left to do, so a scene is played until it has come in time.
TEST_P(ParallelStages, EachIsRunByTwoWorkers) {
    const OdeSession session(3, "lcp");
    const HesitatingCaller hesitation;
    const Scene &scene = GetParam();
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(90);
    while (!missing(scene).empty() && Clock::now() < end) scene.play();
    EXPECT_EQ(missing(scene), "") << "not run by two workers";
}

INSTANTIATE_TEST_SUITE_P(Scenes, ParallelStages, testing::ValuesIn(kScenes),
                         [](const testing::TestParamInfo<Scene> &info) { return std::string(info.param.name); });

TEST(ParallelStagesTable, EachIsInAScene) {
    std::vector<int> scenes(dxParallelStages::kCount);
    for (const Scene &scene : kScenes)
        for (const Stage stage : scene.stages) ++scenes[static_cast<std::size_t>(stage)];
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_EQ(scenes[i], 1) << dxParallelStages::kNames[i];
        EXPECT_NE(dxParallelStages::kNames[i], nullptr) << i;
    }
}

// One worker alone is not taken for two, however many blocks it runs; two are.
TEST(StageWatch, OneWorkerIsNotTwo) {
    constexpr Stage kNone = Stage::Count;
    dxStageWatch one(kNone);
    one.see(1);
    one.see(1);
    dxTaskRunner::alone().forBlocks(kNone, 100, [](unsigned, unsigned) {});
    dxWorkersRunner(1).forBlocks(kNone, 100, [](unsigned, unsigned) {});
    EXPECT_FALSE(dxParallelStages::ranByTwo(kNone));
    one.see(0);
    EXPECT_TRUE(dxParallelStages::ranByTwo(kNone));
    dxStageWatch again(kNone);  // it is known, and stays so
    again.see(0);
    EXPECT_TRUE(dxParallelStages::ranByTwo(kNone));
}

}  // namespace
