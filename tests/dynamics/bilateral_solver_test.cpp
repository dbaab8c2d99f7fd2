// The solver of islands all of whose rows are bilateral beside Dantzig's algorithm: chains, trees and rings of joints of all such types.
//
// Covers dxBilateralSystem.cpp.
#include "dynamics/world_step/fast/dxBilateralSolver.h"

#include <random>

#include "compared_solutions.h"

namespace {

constexpr dReal kStepSize = dReal(0.01);

using BilateralSolver = ComparedSolutions;

// Bodies in a tree with rings, held by joints whose rows are bilateral.
class BilateralWorld {
public:
    // `kinds`: of joints, from few rows to many.
    BilateralWorld(unsigned bodies, unsigned kinds, unsigned seed) : m_random(seed), m_world(dWorldCreate()) {
        dWorldSetGravity(m_world, 0, 0, -10);
        for (unsigned i = 0; i < bodies; ++i) {
            m_bodies.push_back(dBodyCreate(m_world));
            dMass mass;
            dMassSetBoxTotal(&mass, dReal(1 + i % 3), dReal(0.3), dReal(0.5), dReal(0.9));
            dBodySetMass(m_bodies.back(), &mass);
            dBodySetPosition(m_bodies.back(), dReal(i), number(), number());
            dBodySetAngularVel(m_bodies.back(), number(), number(), number());
            addJoint(i, i > 0 ? static_cast<int>(i - 1 - m_random() % std::min(i, 4u)) : -1, kinds);
            if (i > 4 && i % 5 == 0) addJoint(i, static_cast<int>(m_random() % (i - 3)), 2);
        }
    }
    ~BilateralWorld() { dWorldDestroy(m_world); }
    BilateralWorld(const BilateralWorld &) = delete;
    BilateralWorld &operator=(const BilateralWorld &) = delete;

    dWorldID world() const { return m_world; }

private:
    dReal number() { return dReal(std::uniform_real_distribution<double>(-1, 1)(m_random)); }

    // `other`: -1 is the world.
    void addJoint(unsigned body, int other, unsigned kinds) {
        static dJointID (*const create[])(dWorldID, dJointGroupID) = {&dJointCreateDBall,  &dJointCreateBall,   &dJointCreateUniversal,
                                                                      &dJointCreateHinge, &dJointCreateSlider, &dJointCreateFixed};
        const unsigned kind = m_random() % kinds;
        const dJointID joint = create[kind](m_world, nullptr);
        dJointAttach(joint, m_bodies[body], other >= 0 ? m_bodies[static_cast<unsigned>(other)] : nullptr);
        const dReal *const here = dBodyGetPosition(m_bodies[body]);
        const dReal x = here[0] - dReal(0.4), y = here[1] + number() / 2, z = here[2] + number() / 2;
        if (kind == 0) dJointSetDBallAnchor1(joint, x, y, z);
        if (kind == 1) dJointSetBallAnchor(joint, x, y, z);
        if (kind == 2) dJointSetUniversalAnchor(joint, x, y, z);
        if (kind == 3) dJointSetHingeAnchor(joint, x, y, z);
        if (kind == 5) dJointSetFixed(joint);
    }

    std::mt19937 m_random;
    const dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};

TEST_F(BilateralSolver, IsAsExactAsUpstreams) {
    dxBilateralSolver solver;
    for (const unsigned kinds : {1u, 2u, 3u, 6u})
        for (const unsigned bodies : {2u, 9u, 30u})
            for (unsigned seed = 0; seed < 8; ++seed) {
                const BilateralWorld world(bodies, kinds, seed);
                for (int i = 0; i < 3; ++i)
                    solveIslands(world.world(), kStepSize, [&](const dxIslandStep &step, const dxWorldStepProblem &problem) {
                        EXPECT_EQ(countBilateralRows(problem), problem.rowCount);
                        compare(step, problem, 1, [&] { return solver.solve(step, problem); });
                    });
            }
    EXPECT_GE(m_tally.islands, 280u);
    EXPECT_LT(m_tally.unsolved, m_tally.islands / 10);
    EXPECT_GT(m_tally.compared, m_tally.islands / 2);
}

}  // namespace
