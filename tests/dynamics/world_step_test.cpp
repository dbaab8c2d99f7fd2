// The exact step of an island gives the bits of upstream's at each stage, for every instruction set of this machine.
//
// Covers dxBodyColumns.cpp, dxBodyForces.cpp, dxConstraintMatrix.cpp, dxDantzigSolver.cpp, dxWorldStepBodies.cpp, dxWorldStepRows.cpp.
#include <gtest/gtest.h>

#include <ode/error.h>

#include <cfenv>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "config.h"
#include "lcp.h"
#include "step.h"
#include "util.h"

#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxIslandSearch.h"
#include "dynamics/world_step/dxWorldStep.h"
#include "dynamics/world_step/dxWorldStepBodies.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "instruction_sets.h"
#include "kept_messages.h"
#include "random_world.h"
#include "upstream_facts.h"
#include "upstream_world_step.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

class RecordingSolver final : public dxWorldStepSolver {
public:
    explicit RecordingSolver(RecordedProblem &recorded) : m_recorded(recorded) {}

    bool solve(const dxIslandStep &step, const dxWorldStepProblem &problem) override {
        dReal *const matrix = dxMakeMatrix(step, problem);
        m_recorded.recordProblem(problem.rowCount, matrix, problem.pairsBX, problem.bilateralJoints, problem.pairsLoHi,
                                 problem.normalOf);
        dxDantzigSolver::solve(step, problem, matrix);
        m_recorded.recordSolution(problem.pairsBX);
        return false;
    }

private:
    RecordedProblem &m_recorded;
};

void stepIslandAsOurs(const dxStepperProcessingCallContext &call, RecordedProblem &problem) {
    RecordingSolver solver(problem);
    const dxIsland island{call.m_islandBodiesStart, call.m_islandJointsStart, call.m_islandBodiesCount, call.m_islandJointsCount};
    dxWorldStep({call.m_world, call.m_stepSize, island, call.m_stepperArena}, solver);
}

// Large islands with bodies in lanes.
void stepIslandInLanes(const dxStepperProcessingCallContext &call, RecordedProblem &problem) {
    RecordingSolver solver(problem);
    const dxIsland island{call.m_islandBodiesStart, call.m_islandJointsStart, call.m_islandBodiesCount, call.m_islandJointsCount};
    dxWorldStep({call.m_world, call.m_stepSize, island, call.m_stepperArena}, solver, dxAreBodiesForLanes(island));
}

struct StepResult {
    std::vector<unsigned> islands;  // bodies and joints of each
    std::vector<RecordedProblem> problems;
    std::string messages;
    bool isLeft = false;
};

using Preparation = decltype(&dxPrepareStep);
using IslandStepper = decltype(&stepIslandAsUpstream);

StepResult step(dxWorld *world, Preparation prepare, IslandStepper stepIsland) {
    StepResult result;
    keptMessages.clear();
    dxWorldProcessIslandsInfo info;
    EXPECT_TRUE(prepare(world, info, kStepSize, &dxEstimateStepMemoryRequirements));
    dxWorldProcessContext *const context = world->unsafeGetWorldProcessingContext();
    dxWorldProcessMemArena *const arena = context->ObtainStepperMemArena();
    dxIslandCursor cursor(info);
    for (sizeint i = 0; i < info.GetIslandsCount() && !result.isLeft; ++i) {
        const dxIsland island = cursor.next();
        arena->ResetState();
        dxStepperProcessingCallContext call = dxSerialStepperCall(world, kStepSize, arena, island.bodies, island.joints);
        call.AssignIslandSelection(island.bodies, island.joints, island.bodyCount, island.jointCount);
        result.islands.insert(result.islands.end(), {island.bodyCount, island.jointCount});
        try {
            stepIsland(call, result.problems.emplace_back());
        } catch (const std::runtime_error &) {
            result.isLeft = true;
        }
    }
    context->ReturnStepperMemArena(arena);
    result.messages = keptMessages;
    return result;
}

void expectSame(const RecordedProblem &upstream, const RecordedProblem &ours) {
    EXPECT_EQ(upstream.rows, ours.rows);
    EXPECT_EQ(upstream.bilateral, ours.bilateral);
    EXPECT_EQ(upstream.normalOf, ours.normalOf);
    EXPECT_EQ(upstream.limits, ours.limits);
    EXPECT_EQ(upstream.rightSide, ours.rightSide);
    EXPECT_EQ(upstream.matrix, ours.matrix);
    EXPECT_EQ(upstream.solution, ours.solution);
}

// Returns the number of rows that were compared.
unsigned expectSameSteps(const RandomWorld::Shape &shape, unsigned seed, int steps, IslandStepper stepIsland = &stepIslandAsOurs) {
    SCOPED_TRACE(std::to_string(shape.joints) + " joints, seed " + std::to_string(seed));
    RandomWorld upstreams(shape, seed), ours(shape, seed);
    unsigned rows = 0;
    bool isLeft = false;
    for (int i = 0; i < steps && !isLeft && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE("step " + std::to_string(i));
        upstreams.push();
        ours.push();
        const StepResult a = step(upstreams.world(), &dxReallocateWorldProcessContext, &stepIslandAsUpstream);
        const StepResult b = step(ours.world(), &dxPrepareStep, stepIsland);
        isLeft = a.isLeft;
        EXPECT_EQ(a.isLeft, b.isLeft);
        EXPECT_EQ(a.islands, b.islands);
        EXPECT_EQ(a.messages, b.messages);
        for (std::size_t k = 0; k < a.problems.size() && k < b.problems.size(); ++k) {
            expectSame(a.problems[k], b.problems[k]);
            rows += a.problems[k].rows;
        }
        EXPECT_EQ(upstreams.state(), ours.state());
    }
    return rows;
}

class WorldStep : public testing::Test {
protected:
    WorldStep() {
        dInitODE2(0);
        dSetMessageHandler(keepMessage);
        dSetDebugHandler(keepMessageAndLeave);
    }
    ~WorldStep() override {
        dSetMessageHandler(nullptr);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }
};

const RandomWorld::Shape kShapes[] = {{1, 0}, {1, 2}, {2, 1}, {2, 6}, {5, 6}, {9, 20}, {20, 30}, {12, 60}};

}  // namespace

TEST_F(WorldStep, HasUpstreamsBits) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [&] {
            unsigned rows = 0;
            for (const RandomWorld::Shape &shape : kShapes)
                for (unsigned seed = 0; seed < 25; ++seed) rows += expectSameSteps(shape, seed, 4);
            EXPECT_GT(rows, 10000u);
        });
    }
}

TEST_F(WorldStep, HasUpstreamsBitsBeyondTheRangeOfNumbers) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [&] {
            for (RandomWorld::Shape shape : kShapes) {
                shape.isExtreme = true;
                for (unsigned seed = 0; seed < 10; ++seed) expectSameSteps(shape, seed, 3);
            }
        });
    }
}

const RandomWorld::Shape kLaneShapes[] = {{9, 20}, {20, 30}, {12, 60}, {60, 40}};

TEST_F(WorldStep, HasUpstreamsBitsWithBodiesInLanes) {
    for (const std::int64_t set : instructionSets()) {
        onInstructionSet(set, [&] {
            for (RandomWorld::Shape shape : kLaneShapes)
                for (unsigned seed = 300; seed < 308; ++seed) {
                    shape.isExtreme = seed % 2 != 0;
                    shape.isQuiet = seed % 4 < 3;
                    expectSameSteps(shape, seed, 4, &stepIslandInLanes);
                }
        });
    }
}

// Lanes that are not read must not trap.
TEST_F(WorldStep, HasUpstreamsBitsWithExceptionsTrapped) {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    for (const RandomWorld::Shape &shape : kShapes)
        for (unsigned seed = 100; seed < 110; ++seed) expectSameSteps(shape, seed, 3);
    fedisableexcept(FE_ALL_EXCEPT);
}

// Upwards and downwards two builds of upstream differ already (docs/exactness.md).
TEST_F(WorldStep, HasUpstreamsBitsRoundedToZero) {
    std::fesetround(FE_TOWARDZERO);
    for (const RandomWorld::Shape &shape : kShapes)
        for (unsigned seed = 200; seed < 220; ++seed) expectSameSteps(shape, seed, 3);
    std::fesetround(FE_TONEAREST);
}
