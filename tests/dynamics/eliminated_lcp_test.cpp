// Dantzig's algorithm for the unilateral rows alone, the bilateral ones being eliminated, beside Dantzig's algorithm for all rows, on islands
// of random worlds: joints of all types, motors, stops, friction, kinematic bodies.
//
// Covers dxRowBlocks.cpp.
#include "dynamics/world_step/fast/dxEliminatedLcp.h"

#include "compared_solutions.h"
#include "random_world.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

// The judge's limits of friction are those of its own normals' forces, which rounding makes others than the elimination's.
constexpr double kOtherLimits = 8;

using EliminatedLcp = ComparedSolutions;

const RandomWorld::Shape kShapes[] = {{2, 1}, {2, 6}, {5, 6}, {9, 20}, {20, 30}, {12, 60}, {60, 120}};

TEST_F(EliminatedLcp, IsAsExactAsUpstreams) {
    dxEliminatedLcp eliminated;
    for (const RandomWorld::Shape &shape : kShapes)
        for (unsigned seed = 0; seed < 20; ++seed) {
            RandomWorld world(shape, seed);
            for (int i = 0; i < 3; ++i) {
                world.push();
                solveIslands(world.world(), kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
                    if (countBilateralRows(problem) == 0)
                        dxDantzigSolver().solve(step, problem);
                    else
                        compare(step, problem, kOtherLimits, [&] { return eliminated.solve(step, problem); });
                });
            }
        }
    EXPECT_GT(m_tally.islands, 500u);
    EXPECT_LT(m_tally.unsolved, m_tally.islands / 2);  // joints at random contradict one another
    EXPECT_GT(m_tally.compared, m_tally.islands / 3);
}

}  // namespace
