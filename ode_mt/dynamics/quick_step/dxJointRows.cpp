#include "dynamics/quick_step/dxJointRows.h"

#include <algorithm>

#include "dynamics/step/islands/dxForBodies.h"
#include "joints/joint.h"

namespace {

using Row = dxConstraintRow;

constexpr std::size_t kJointsPerJob = 32;  // some ten microseconds

// From one row to the next, in the unit that joints count in.
constexpr int kRowStride = sizeof(Row) / sizeof(dReal);
static_assert(sizeof(Row) % sizeof(dReal) == 0, "joints step from row to row by whole numbers");

// Before a joint writes what it has to say: free, without bounds, with the world's cfm.
void resetRow(Row &row, dReal cfm) {
    std::fill_n(row.jacobian, Row::kColumns, dReal(0));
    row.jacobian[Row::kCfm] = cfm;
    row.jacobian[Row::kLow] = -dInfinity;
    row.jacobian[Row::kHigh] = dInfinity;
}

int indexOf(const dxBody *body) { return body != nullptr ? body->tag : Row::kNone; }

// J' lambda of the rows' columns of one body.
void addUp(const dReal *columns, std::size_t stride, const Row *rows, unsigned count, dReal *force, dReal *torque) {
    dReal sum[6] = {};
    for (unsigned row = 0; row < count; ++row)
        for (int i = 0; i < 6; ++i) sum[i] += columns[row * stride + static_cast<std::size_t>(i)] * rows[row].lambda;
    std::copy_n(sum, 3, force);
    std::copy_n(sum + 3, 3, torque);
}

}  // namespace

void dxReadJointRows(const dxIslandStep &step, dxJoint &joint, unsigned firstRow, unsigned count, Row *rows) {
    const dReal perStep = dRecip(step.stepSize);
    const dxWorld &world = *step.world;
    for (unsigned i = 0; i < count; ++i) resetRow(rows[i], world.global_cfm);
    int boundingRow[Row::kMaxOfJoint];
    std::fill_n(boundingRow, count, Row::kNone);

    dReal *const first = reinterpret_cast<dReal *>(rows);
    joint.getInfo2(perStep, world.global_erp, kRowStride, first + Row::kBody1, first + Row::kBody2, kRowStride, first + Row::kRhs,
                   first + Row::kLow, boundingRow);

    const int body1 = indexOf(joint.node[0].body), body2 = indexOf(joint.node[1].body);
    for (unsigned i = 0; i < count; ++i) {
        Row &row = rows[i];
        row.jacobian[Row::kRhs] *= perStep;
        row.jacobian[Row::kCfm] *= perStep;
        row.lambda = 0;
        row.body[0] = body1;
        row.body[1] = body2;
        row.boundingRow = boundingRow[i] == Row::kNone ? Row::kNone : boundingRow[i] + static_cast<int>(firstRow);
    }
}

dxJointRows::dxJointRows(const dxIslandStep &step) : m_step(step) {
    const dxIsland &island = step.island;
    void *const state = step.arena->SaveState();
    m_joints = step.arena->AllocateArray<Joint>(island.jointCount);
    unsigned rows = 0, copies = 0;
    for (unsigned i = 0; i < island.jointCount; ++i) {
        dxJoint *const joint = island.joints[i];
        dxJoint::Info1 info;
        joint->getInfo1(&info);
        if (info.m == 0) continue;
        m_joints[m_jointCount++] = {joint, rows, copies};
        rows += info.m;
        if (joint->feedback != nullptr) copies += info.m;
    }
    // Shorter, or longer by one; upstream's estimate has room for that where all joints have rows.
    step.arena->RestoreState(state);
    step.arena->AllocateArray<Joint>(m_jointCount + 1);
    m_joints[m_jointCount] = {nullptr, rows, copies};
    if (copies != 0) m_copies = step.arena->AllocateArray<dReal>(copies * kCopyColumns);
}

void dxJointRows::read(Row *rows) {
    const bool isShared = m_step.islandWorkers != nullptr && hasOnlyContacts();
    dxTaskRunner &runner = isShared ? m_step.runner() : dxTaskRunner::alone();
    runner.forChunks(dxParallelStage::Joints, m_jointCount, kJointsPerJob,
                     [&](std::size_t begin, std::size_t end, unsigned) { readAll(rows, begin, end); });
}

bool dxJointRows::hasOnlyContacts() const {
    return std::all_of(m_step.island.joints, m_step.island.joints + m_step.island.jointCount,
                       [](const dxJoint *joint) { return joint->type() == dJointTypeContact; });
}

void dxJointRows::readAll(Row *rows, std::size_t begin, std::size_t end) const {
    const auto read = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) readJoint(rows, m_joints[i]);
    };
    if (m_step.island.bodyCount < dxIslandPrefetch::kMinBodies) return read(begin, end);
    dxIslandPrefetch::forChunks(begin, end, m_jointCount, [this](std::size_t i) { dxIslandPrefetch::joint(m_joints[i].joint); }, read);
}

void dxJointRows::readJoint(Row *rows, const Joint &joint) const {
    Row *const own = rows + joint.firstRow;
    dxReadJointRows(m_step, *joint.joint, joint.firstRow, rowsOf(joint), own);
    if (hasCopy(joint)) copyJacobian(own, joint);
}

// The solver overwrites it.
void dxJointRows::copyJacobian(const Row *rows, const Joint &joint) const {
    dReal *copy = m_copies + joint.firstCopy * kCopyColumns;
    for (unsigned i = 0; i < rowsOf(joint); ++i, copy += kCopyColumns) {
        std::copy_n(rows[i].jacobian + Row::kBody1, 6, copy);
        std::copy_n(rows[i].jacobian + Row::kBody2, 6, copy + 6);
    }
}

void dxJointRows::giveFeedback(const Row *rows) const {
    if (m_copies == nullptr) return;
    for (unsigned i = 0; i < m_jointCount; ++i) {
        const Joint &joint = m_joints[i];
        if (!hasCopy(joint)) continue;
        dJointFeedback &feedback = *joint.joint->feedback;
        const dReal *const copy = m_copies + joint.firstCopy * kCopyColumns;
        const Row *const own = rows + joint.firstRow;
        if (joint.joint->node[1].body != nullptr)
            addUp(copy + 6, kCopyColumns, own, rowsOf(joint), feedback.f2, feedback.t2);
        addUp(copy, kCopyColumns, own, rowsOf(joint), feedback.f1, feedback.t1);
    }
}
