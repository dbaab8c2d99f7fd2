// Forces of Dantzig's algorithm are an answer wherever it does not give up, in worlds whose rows neither repeat nor contradict one another.
// (hard_rows_test.cpp has the others.)
//
// More random worlds with ODE_MT_EXACTNESS=thorough.
#include "dynamics/world_step/fast/dxDantzigTrial.h"

#include <gtest/gtest.h>

#include <ode/ode.h>

#include "../exactness/thorough.h"
#include "../frame/OdeSession.h"
#include "island_rows.h"
#include "random_world.h"
#include "robot_world.h"

#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/fast/dxFastWorldStep.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

unsigned countOfWorlds() { return exactness::isThorough() ? 1200 : 40; }

// Joints of all types between bodies at random, robots on contacts.
class Trials {
public:
    void step(dWorldID world) {
        solveIslands(world, kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
            // The trial's memory is another arena's, as that of "exact" has no room for it.
            const dxIsland &island = step.island;
            const dxArenaLease arena(dxEstimateFastWorldStepMemory(island.bodies, island.bodyCount, island.joints, island.jointCount));
            dxIslandStep own = step;
            own.arena = arena.get();
            dxHeldMessage message;
            const dxDantzigTrial trial(own, problem, message);
            ++m_islands;
            m_failures += !trial.isAnswer() && !message.isHeld();
        });
    }
    unsigned islands() const { return m_islands; }
    unsigned failures() const { return m_failures; }

private:
    unsigned m_islands = 0, m_failures = 0;
};

TEST(DantzigTrial, HasAnAnswerInWellPosedWorlds) {
    const OdeSession session;
    Trials trials;
    for (unsigned seed = 0; seed < countOfWorlds(); ++seed) {
        RobotWorld robots({3, 9 + seed % 20, seed % 12}, seed);
        RandomWorld random({3 + seed % 20, 2 + seed % 20}, seed);
        for (int i = 0; i < 3; ++i) {
            random.push();
            for (const dWorldID world : {robots.world(), random.world()}) trials.step(world);
        }
    }
    EXPECT_GE(trials.islands(), 10 * countOfWorlds());
    EXPECT_EQ(trials.failures(), 0u);
}

}  // namespace
