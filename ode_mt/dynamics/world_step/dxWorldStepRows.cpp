#include "dynamics/world_step/dxWorldStepRows.h"

#include <ode/odemath.h>

#include <algorithm>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/kernels/dxConstraintMatrix.h"
#include "dynamics/world_step/kernels/dxPair.h"

namespace {

// --- order -----------------------------------------------------------------------------------------------------

// Three lists side by side, which grow from the middle of an array in both directions:
//
//   begin           mixed           unilateral        end
//     | bilateral     | mixed         | unilateral      |
//
// A mixed joint goes to the end of its list that lies away from where the last joint of another kind went, unless nothing is
// behind it on the other side; the neighbour in its way moves to the far end of its own list. That is upstream's order.
class Lists {
public:
    explicit Lists(dxWorldStepJoint *middle) : m_begin(middle), m_mixed(middle), m_unilateral(middle), m_end(middle) {}

    void addBilateral(const dxWorldStepJoint &joint) {
        *--m_begin = joint;
        m_wasBilateral = true;
    }

    void addUnilateral(const dxWorldStepJoint &joint) {
        *m_end++ = joint;
        m_wasBilateral = false;
    }

    void addMixed(const dxWorldStepJoint &joint) {
        if (m_wasBilateral ? m_unilateral == m_end : m_begin != m_mixed)
            appendMixed(joint);
        else
            prependMixed(joint);
    }

    dxWorldStepJoint *begin() const { return m_begin; }
    dxWorldStepJoint *end() const { return m_end; }
    unsigned countBilateral() const { return static_cast<unsigned>(m_mixed - m_begin); }

private:
    // Where the neighbouring list is empty, an element is copied to its own place.
    void appendMixed(const dxWorldStepJoint &joint) {
        *m_end++ = *m_unilateral;
        *m_unilateral++ = joint;
    }

    void prependMixed(const dxWorldStepJoint &joint) {
        *--m_begin = m_mixed[-1];
        *--m_mixed = joint;
    }

    dxWorldStepJoint *m_begin, *m_mixed, *m_unilateral, *m_end;
    bool m_wasBilateral = false;
};

// Upstream's tag of a joint without rows.
constexpr int kNoRows = -1;

// Numbers the joints and their rows. Returns how many rows there are.
unsigned numberRows(dxWorldStepJoint *begin, const dxWorldStepJoint *end) {
    unsigned row = 0;
    for (dxWorldStepJoint *joint = begin; joint != end; ++joint) {
        joint->joint->tag = static_cast<int>(joint - begin);
        joint->firstRow = row;
        row += joint->rows;
    }
    return row;
}

// --- rows ------------------------------------------------------------------------------------------------------

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;
static_assert(kPair == int(dxJoint::GI2__LO_HI_MAX), "joints are told one distance for pairs of both kinds");
static_assert(kPair == 2 && int(dxJoint::GI2_RHS) == 0 && int(dxJoint::GI2_CFM) == 1 && int(dxJoint::GI2_LO) == 0 &&
                  int(dxJoint::GI2_HI) == 1,
              "rows are cleared by pairs");

// A hinge may write one row more than it has announced: if its stop is taken away while it rests on it, it keeps the stop's state (upstream's
// dxJointHinge::getInfo1 does not look at stops that are infinite or crossed). That row goes where upstream's memory has it: into the joint's
// rows of the second body and the next joint's, which is cleared after that; of the last joint the right side goes into the first row's
// limits, the limits into the links, which are made later, and the Jacobian into what the arena has left for the matrix.
void takeMemory(dxWorldProcessMemArena &arena, dxWorldStepProblem &problem) {
    const std::size_t rows = problem.rowCount;
    problem.normalOf = arena.AllocateArray<int>(rows);
    problem.pairsBX = arena.AllocateArray<dReal>(rows * kPair);
    problem.pairsLoHi = arena.AllocateArray<dReal>(rows * kPair);
    problem.links.first = arena.AllocateArray<unsigned>(problem.bodyCount);
    problem.links.next = arena.AllocateArray<unsigned>(std::size_t(problem.jointCount) * dxWorldStepProblem::kSides);
    problem.jacobian = arena.AllocateArray<dReal>(rows * dxWorldStepProblem::kSides * dxWorldStepProblem::kElements);
}

// What the joint finds before it writes.
void clearRows(const dxWorldStepProblem &problem, const dxWorldStepJoint &joint, dReal cfm) {
    std::fill_n(problem.rowsOf(joint, dJCB_FIRST_BODY), joint.rows * dxWorldStepProblem::kSides * dxWorldStepProblem::kElements, dReal(0));
    const dxPair rightSide = {0, cfm}, limits = {-dInfinity, dInfinity};
    for (std::size_t i = joint.firstRow; i < std::size_t(joint.firstRow) + joint.rows; ++i) {
        dxStorePair(rightSide, problem.pairsBX + i * kPair);
        dxStorePair(limits, problem.pairsLoHi + i * kPair);
        problem.normalOf[i] = -1;
    }
}

// Adds a joint to its bodies' lists.
void link(const dxWorldStepProblem &problem, unsigned joint) {
    const dxJointNode *const nodes = problem.joints[joint].joint->node;
    for (unsigned side = 0; side < dxWorldStepProblem::kSides && nodes[side].body != nullptr; ++side)
        problem.links.add(static_cast<unsigned>(nodes[side].body->tag), dxBodyLinks::linkOf(joint, side));
}

void askJoints(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    const dReal framesPerSecond = dRecip(step.stepSize), erp = step.world->global_erp;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        const std::size_t row = joint.firstRow;
        clearRows(problem, joint, step.world->global_cfm);
        int *const normalOf = problem.normalOf + row;
        joint.joint->getInfo2(framesPerSecond, erp, dxWorldStepProblem::kElements, problem.rowsOf(joint, dJCB_FIRST_BODY),
                              problem.rowsOf(joint, dJCB_SECOND_BODY), kPair, problem.pairsBX + row * kPair,
                              problem.pairsLoHi + row * kPair, normalOf);
        // Joints count from their own first row.
        for (unsigned k = 0; k < joint.rows; ++k)
            if (normalOf[k] != -1) normalOf[k] += static_cast<int>(row);
    }
    std::fill_n(problem.links.first, problem.bodyCount, dxBodyLinks::kNone);
    for (unsigned i = 0; i < problem.jointCount; ++i) link(problem, i);
    for (dReal *pair = problem.pairsBX; pair != problem.pairsBX + std::size_t(problem.rowCount) * kPair; pair += kPair)
        dxStorePair(dxLoadPair(pair) * framesPerSecond, pair);
}

}  // namespace

void dxOrderJoints(const dxIslandStep &step, dxWorldStepProblem &problem) {
    const std::size_t count = step.island.jointCount;
    dxWorldStepJoint *const array = step.arena->AllocateArray<dxWorldStepJoint>(2 * count);
    Lists lists(array + count);
    for (std::size_t i = 0; i < count; ++i) {
        dxJoint *const joint = step.island.joints[i];
        dxJoint::Info1 info;
        joint->getInfo1(&info);
        dIASSERT(info.m <= kMaxJointRows && info.nub <= info.m);
        if (info.m == 0) {
            joint->tag = kNoRows;
            continue;
        }
        const dxWorldStepJoint entry{joint, 0, info.m};
        if (info.nub == 0)
            lists.addUnilateral(entry);
        else if (info.nub < info.m)
            lists.addMixed(entry);
        else
            lists.addBilateral(entry);
    }
    step.arena->ShrinkArray(array, 2 * count, static_cast<std::size_t>(lists.end() - array));
    problem.joints = lists.begin();
    problem.jointCount = static_cast<unsigned>(lists.end() - lists.begin());
    problem.bilateralJoints = lists.countBilateral();
    problem.rowCount = numberRows(lists.begin(), lists.end());
}

void dxReadRows(const dxIslandStep &step, dxWorldStepProblem &problem) {
    takeMemory(*step.arena, problem);
    askJoints(step, problem);
}
