// Each stage of QuickStep gives the bits of upstream's, for every instruction set of this machine, alone and by a team.
#include "dynamics/quickstep/dxIslandBodies.h"
#include "dynamics/quickstep/dxJointRows.h"
#include "dynamics/quickstep/dxQuickStep.h"
#include "dynamics/quickstep/dxSorSolver.h"
#include "quickstep.h"
#include "instruction_sets.h"
#include "random_island.h"
#include "upstream_quickstep.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace {

constexpr dReal kStepSize = dReal(0.01);

class QuickStepStages : public testing::TestWithParam<unsigned> {  // number of bodies
protected:
    static void SetUpTestSuite() { dInitODE2(0); }
    static void TearDownTestSuite() { dCloseODE(); }
};

// Memory of the size of upstream's estimate, as a step has it.
class Arena {
public:
    Arena(const RandomIsland &island)
        : m_manager(&allocate, &reallocate, &release),
          m_arena(dxWorldProcessMemArena::ReallocateMemArena(
              nullptr,
              dxEstimateQuickStepMemoryRequirements(island.bodies.data(), unsigned(island.bodies.size()), island.joints.data(),
                                                    unsigned(island.joints.size())),
              &m_manager, 1, 0)) {
        m_arena->ResetState();
    }
    ~Arena() { dxWorldProcessMemArena::FreeMemArena(m_arena); }
    dxWorldProcessMemArena *get() const { return m_arena; }

private:
    static void *allocate(std::size_t size) { return ::operator new(size); }
    static void *reallocate(void *, std::size_t, std::size_t) { return nullptr; }
    static void release(void *block, std::size_t) { ::operator delete(block); }

    dxWorldProcessMemoryManager m_manager;
    dxWorldProcessMemArena *m_arena;
};

dxIslandStep stepOf(const RandomIsland &island, const Arena &arena) {
    return {island.world, kStepSize,
            {island.bodies.data(), island.joints.data(), unsigned(island.bodies.size()), unsigned(island.joints.size())}, arena.get()};
}

template <class Number>
testing::AssertionResult sameBits(const std::vector<Number> &ours, const std::vector<Number> &upstream) {
    if (ours.size() != upstream.size()) return testing::AssertionFailure() << ours.size() << " against " << upstream.size();
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (std::memcmp(&ours[i], &upstream[i], sizeof(Number)) != 0)
            return testing::AssertionFailure() << "entry " << i << ": " << ours[i] << " against " << upstream[i];
    return testing::AssertionSuccess();
}

// The columns of rows, those of absent bodies left out.
std::vector<dReal> columnsOf(const std::vector<dReal> &jacobian, const std::vector<int> &bodies) {
    std::vector<dReal> columns;
    for (std::size_t row = 0; row < bodies.size() / 2; ++row)
        for (std::size_t i = 0; i < 16; ++i)
            if (bodies[2 * row + 1] != -1 || i < 8 || i > 13) columns.push_back(jacobian[16 * row + i]);
    return columns;
}

struct Rows {
    explicit Rows(const dxIslandProblem &problem) {
        for (unsigned i = 0; i < problem.rowCount; ++i) {
            const dxConstraintRow &row = problem.rows[i];
            jacobian.insert(jacobian.end(), row.jacobian, row.jacobian + 16);
            bodies.insert(bodies.end(), row.body, row.body + 2);
            boundingRow.push_back(row.boundingRow);
            lambda.push_back(row.lambda);
        }
    }
    std::vector<dReal> jacobian, lambda;
    std::vector<int> bodies, boundingRow;
};

TEST_P(QuickStepStages, GiveUpstreamsBits) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        RandomIsland reference(seed, GetParam());
        dRandSetSeed(seed);
        const UpstreamQuickStep upstream = stepByUpstream(reference.world, kStepSize, reference.bodies, reference.joints);
        const unsigned long drawn = dRandGetSeed();
        for (const std::int64_t set : instructionSets()) {
            onInstructionSet(set, [&] {
                RandomIsland island(seed, GetParam());
                const Arena arena(island);
                const dxIslandStep step = stepOf(island, arena);
                const unsigned bodyCount = step.island.bodyCount;
                std::vector<dxIslandBody> bodies(bodyCount);

                dxGatherBodies(step, bodies.data());
                std::vector<dReal> forces, invInertia, upstreamInvInertia;
                for (unsigned i = 0; i < bodyCount; ++i) {
                    forces.insert(forces.end(), island.bodies[i]->facc, island.bodies[i]->facc + 3);
                    forces.insert(forces.end(), island.bodies[i]->tacc, island.bodies[i]->tacc + 3);
                    invInertia.insert(invInertia.end(), bodies[i].invInertia, bodies[i].invInertia + 9);
                    for (unsigned entry = 0; entry < 12; ++entry)
                        if (entry % 4 != 3) upstreamInvInertia.push_back(upstream.invInertia[12 * i + entry]);
                }
                ASSERT_TRUE(sameBits(forces, upstream.forces));
                ASSERT_TRUE(sameBits(invInertia, upstreamInvInertia));

                dxJointRows joints(step);
                ASSERT_EQ(joints.rowCount(), upstream.boundingRow.size());
                if (joints.rowCount() == 0) return;  // nothing to solve; the test below steps such islands
                std::vector<dxConstraintRow> rows(joints.rowCount());
                std::vector<dReal> acceleration(6 * bodyCount);
                std::vector<int> order(rows.size());
                const dxIslandProblem problem{joints.rowCount(), bodyCount, rows.data(), bodies.data(), acceleration.data(),
                                              order.data()};
                joints.read(rows.data());
                const Rows read(problem);
                ASSERT_TRUE(sameBits(read.bodies, upstream.bodies));
                ASSERT_TRUE(sameBits(read.boundingRow, upstream.boundingRow));
                ASSERT_TRUE(sameBits(columnsOf(read.jacobian, read.bodies), columnsOf(upstream.jacobian, read.bodies)));

                dxFindFreeAccelerations(step, problem);
                ASSERT_TRUE(sameBits(acceleration, upstream.freeAcceleration));

                dRandSetSeed(seed);
                dxSorSolver(step).solve(problem);
                EXPECT_EQ(dRandGetSeed(), drawn);
                const Rows solved(problem);
                ASSERT_TRUE(sameBits(columnsOf(solved.jacobian, read.bodies), columnsOf(upstream.scaledJacobian, read.bodies)));
                for (unsigned i = 0; i < rows.size(); ++i)
                    ASSERT_EQ(std::memcmp(rows[i].impulse, &upstream.impulse[12 * i], (rows[i].hasSecondBody() ? 12 : 6) * sizeof(dReal)), 0);
                ASSERT_TRUE(sameBits(solved.lambda, upstream.lambda));
                ASSERT_TRUE(sameBits(acceleration, upstream.acceleration));

                joints.giveFeedback(rows.data());
                dxIntegrateVelocities(step, bodies.data(), acceleration.data());
                dxMoveBodies(step);
                ASSERT_TRUE(sameBits(island.state(), reference.state()));
            });
        }
    }
}

// The page that puts the stages together, in memory of the estimated size.
TEST_P(QuickStepStages, TogetherGiveUpstreamsStep) {
    for (unsigned seed = 100; seed < 130; ++seed) {
        RandomIsland reference(seed, GetParam()), island(seed, GetParam());
        for (int i = 0; i < 3; ++i) {
            dRandSetSeed(seed);
            stepByUpstream(reference.world, kStepSize, reference.bodies, reference.joints);
            dRandSetSeed(seed);
            const Arena arena(island);
            dxQuickStep(stepOf(island, arena));
            ASSERT_TRUE(sameBits(island.state(), reference.state())) << "seed " << seed << ", step " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, QuickStepStages, testing::Values(1u, 2u, 9u, 60u, 250u));

}  // namespace
