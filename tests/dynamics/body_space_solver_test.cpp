// The body space solver beside Dantzig's algorithm, on islands of random worlds: joints of all types, motors, stops, friction, kinematic bodies.
//
// Covers dxBodySpaceProblem.cpp.
#include "dynamics/world_step/fast/dxBodySpaceSolver.h"

#include "compared_solutions.h"
#include "random_world.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

using BodySpaceSolver = ComparedSolutions;

const RandomWorld::Shape kShapes[] = {{2, 1}, {2, 6}, {5, 6}, {9, 20}, {20, 30}, {12, 60}, {60, 120}};

TEST_F(BodySpaceSolver, IsAsExactAsUpstreams) {
    unsigned islands = 0;
    for (const RandomWorld::Shape &shape : kShapes)
        for (unsigned seed = 0; seed < 20; ++seed) {
            RandomWorld world(shape, seed);
            for (int i = 0; i < 3; ++i) {
                world.push();
                solveIslands(world.world(), kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
                    ++islands;
                    compare(step, problem, 1, [&] {
                        m_judge.writeForces(problem);
                        return true;
                    });
                });
            }
        }
    EXPECT_GT(m_tally.islands, 500u);
    EXPECT_EQ(m_tally.islands, islands);  // all were solved
    EXPECT_GT(m_tally.compared, m_tally.islands / 3);
    EXPECT_GT(m_tally.better, m_tally.islands / 2);
}

}  // namespace
