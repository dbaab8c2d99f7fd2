// The order of rows: each once, that of the plan where there are contacts alone; otherwise rows that others bound last, and from the tenth
// sweep on a random order that follows from the numbers that were mixed in.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/quick_step/fast/dxRowOrder.h"

namespace {

// A row of bodies, each of which touches the next one; contacts that roll are no lanes.
class RowOrder : public testing::Test {
protected:
    static constexpr unsigned kJoints = 12, kRowsPerJoint = 3;

    RowOrder() {
        dInitODE2(0);
        m_world = dWorldCreate();
        for (unsigned i = 0; i <= kJoints; ++i) m_bodies.push_back(dBodyCreate(m_world));
        for (unsigned i = 0; i < m_bodies.size(); ++i) m_bodies[i]->tag = static_cast<int>(i);
    }
    ~RowOrder() override {
        dWorldDestroy(m_world);
        dCloseODE();
    }

    // The order after `sweeps` sweeps; the last joint is a ball if `hasBall`.
    std::vector<int> orderAfter(unsigned sweeps, bool hasBall, double state = 1) {
        std::vector<dJointID> joints;
        for (unsigned i = 0; i < kJoints; ++i) {
            dContact contact = {};
            contact.surface.mode = dContactRolling;
            joints.push_back(hasBall && i + 1 == kJoints ? dJointCreateBall(m_world, nullptr) : dJointCreateContact(m_world, nullptr, &contact));
            dJointAttach(joints.back(), m_bodies[i], m_bodies[i + 1]);
        }
        const dxIsland group{m_bodies.data(), joints.data(), static_cast<unsigned>(m_bodies.size()), kJoints};
        dxStepArena arena;
        dxConstraintPlan plan;
        plan.make(group, arena);
        const dxArenaArray<unsigned> firstRow = arena.take<unsigned>(kJoints + 1);
        for (unsigned i = 0; i <= kJoints; ++i) firstRow[i] = i * kRowsPerJoint;
        std::vector<dxConstraintRow> rows(kJoints * kRowsPerJoint);
        for (unsigned i = 0; i < rows.size(); ++i)
            rows[i].boundingRow = i % kRowsPerJoint == 0 ? dxConstraintRow::kNone : static_cast<int>(i - i % kRowsPerJoint);
        dxRowOrder order;
        order.reserve(kJoints, rows.size(), arena);
        order.make(plan, firstRow, rows.data());
        order.mix(state);
        for (unsigned sweep = 1; sweep <= sweeps; ++sweep) order.inSweep(0, kJoints, sweep);
        for (const dJointID joint : joints) dJointDestroy(joint);
        const dxArenaArray<const int> all = order.of(0, kJoints);
        std::vector<int> result(all.begin(), all.end()), sorted = result, numbers(rows.size());
        std::sort(sorted.begin(), sorted.end());
        std::iota(numbers.begin(), numbers.end(), 0);
        EXPECT_EQ(sorted, numbers);
        return result;
    }

    static bool isBounded(int row) { return row % static_cast<int>(kRowsPerJoint) != 0; }

private:
    dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};

TEST_F(RowOrder, OfContactsIsThatOfThePlan) {
    const std::vector<int> order = orderAfter(0, false);
    for (std::size_t i = 0; i < order.size(); i += kRowsPerJoint)
        for (unsigned k = 0; k < kRowsPerJoint; ++k) EXPECT_EQ(order[i + k], order[i] + static_cast<int>(k));
    EXPECT_EQ(orderAfter(9, false), order);
    EXPECT_NE(orderAfter(10, false), order);
}

TEST_F(RowOrder, TakesRowsThatOthersBoundLast) {
    std::vector<int> expected = orderAfter(0, true);
    const auto firstBounded = std::find_if(expected.begin(), expected.end(), isBounded);
    EXPECT_TRUE(std::is_sorted(expected.begin(), firstBounded));
    EXPECT_TRUE(std::is_sorted(firstBounded, expected.end()));
    EXPECT_TRUE(std::all_of(firstBounded, expected.end(), isBounded));
    EXPECT_EQ(orderAfter(9, true), expected);
}

TEST_F(RowOrder, IsRandomFromTheTenthSweepOn) {
    EXPECT_NE(orderAfter(10, true), orderAfter(9, true));
    EXPECT_EQ(orderAfter(18, true), orderAfter(10, true));
    EXPECT_NE(orderAfter(19, true), orderAfter(18, true));
    EXPECT_EQ(orderAfter(19, true), orderAfter(19, true));
    EXPECT_NE(orderAfter(10, true, 2), orderAfter(10, true, 1));
}

}  // namespace
