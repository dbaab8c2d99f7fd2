#include "dynamics/quick_step/fast/dxJointReader.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <ode/odemath.h>

#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/fast/dxContactCache.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/step/islands/dxForBodies.h"

namespace {

using Row = dxConstraintRow;

constexpr std::size_t kPrefetchDistance = 4;  // joints
constexpr std::size_t kPacksPerJob = 4;       // some ten microseconds

// Largest over-relaxation with which joints begin with forces of the last step. With 1.6 and a step of 1 ms a net of a hundred boxes never comes to
// rest, and with 1.9 it flies apart.
constexpr dReal kMaxWarmRelaxation = dReal(1.5);

void writeRow(const Row &row, dReal stepSize, bool hasSecondBody, dxJointLanes &lanes, unsigned lane) {
    constexpr int kAngular = 3;
    const dReal *const onA = row.jacobian + Row::kBody1 + kAngular, *const onB = row.jacobian + Row::kBody2 + kAngular;
    dVector3 together;
    dCopyVector3(together, onA);
    if (hasSecondBody) dAddVectors3(together, onA, onB);
    dxSetLane(lanes.linear, lane, row.jacobian + Row::kBody1);
    dxSetLane(lanes.angular, lane, onA);
    dxSetLane(lanes.together, lane, together);
    lanes.bias.set(lane, stepSize * row.jacobian[Row::kRhs]);
    lanes.softness.set(lane, row.jacobian[Row::kCfm]);
    lanes.low.set(lane, stepSize * row.jacobian[Row::kLow]);
    lanes.high.set(lane, stepSize * row.jacobian[Row::kHigh]);
}

// Adds the force of a row on body A, its torque, and that on B.
void addForce(const dxJointLanes &row, unsigned lane, dReal perStep, dReal *force, dReal *torqueOnA, dReal *torqueOnB) {
    const dReal size = perStep * static_cast<dReal>(row.impulse.lane[lane]);
    for (int axis = 0; axis < 3; ++axis) {
        const auto onA = static_cast<dReal>(row.angular[axis].lane[lane]), both = static_cast<dReal>(row.together[axis].lane[lane]);
        force[axis] += size * static_cast<dReal>(row.linear[axis].lane[lane]);
        torqueOnA[axis] += size * onA;
        torqueOnB[axis] += size * (both - onA);
    }
}

}  // namespace

unsigned dxJointReader::read(dxJointLanes *rows) const {
    std::atomic<unsigned> count{0};
    dxTaskRunner &runner = m_plan.hasPassiveLaneJoints() ? m_step.runner() : dxTaskRunner::alone();
    runner.forChunks(dxParallelStage::Joints, m_plan.jointPacks().size(), kPacksPerJob, [&](std::size_t begin, std::size_t end, unsigned) {
        unsigned found = 0;
        for (std::size_t i = begin; i < end; ++i) found += readPack(i, rows + m_plan.jointPacks()[i].firstRow);
        count.fetch_add(found, std::memory_order_relaxed);
    });
    return count.load(std::memory_order_relaxed);
}

// Returns the number of rows of all its joints.
unsigned dxJointReader::readPack(std::size_t number, dxJointLanes *rows) const {
    const dxArenaArray<LaneJoint> joints = m_plan.laneJoints();
    dxJointPack &pack = m_plan.jointPacks()[number];
    std::memset(rows, 0, pack.rowCount * sizeof(dxJointLanes));
    pack.rowCount = 0;
    unsigned count = 0;
    for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
        const std::size_t next = number * dxLanes::kCount + lane + kPrefetchDistance;
        if (next < joints.size() && !joints[next].isEmpty()) dxIslandPrefetch::joint(&jointOf(joints[next]));
        if (laneJoint(number, lane).isEmpty()) continue;
        const unsigned found = readJoint(laneJoint(number, lane), rows, lane);
        joints[number * dxLanes::kCount + lane].rowCount = static_cast<std::uint8_t>(found);
        pack.rowCount = std::max(pack.rowCount, found);
        count += found;
    }
    return count;
}

unsigned dxJointReader::readJoint(const LaneJoint &own, dxJointLanes *rows, unsigned lane) const {
    dxJoint &joint = jointOf(own);
    dxJoint::Info1 info;
    joint.getInfo1(&info);
    Row read[Row::kMaxOfJoint];
    dxReadJointRows(m_step, joint, 0, info.m, read);
    const bool isWarm = m_step.fastQuickStep->isWarm() && m_step.world->qs.w <= kMaxWarmRelaxation &&
                        dxKeptJointForces::areOf(joint, m_step.fastQuickStep->lastStep(), info.m);
    const dReal part = isWarm ? dxWarmStartFactor(m_step.world->global_erp) * m_step.stepSize : 0;
    for (unsigned k = 0; k < info.m; ++k) {
        writeRow(read[k], m_step.stepSize, joint.node[1].body != nullptr, rows[k], lane);
        const dReal impulse = part * joint.lambda[k];
        rows[k].impulse.set(lane, std::isfinite(impulse) ? impulse : 0);
    }
    return info.m;
}

void dxJointReader::readBodies(unsigned begin, unsigned end, const dxIslandBody *masses) const {
    for (unsigned i = begin; i < end; ++i)
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            dxJointPack &pack = m_plan.jointPacks()[i];
            pack.clear(lane, m_step.island.bodyCount);
            pack.set(lane, laneJoint(i, lane).body, masses);
        }
}

void dxJointReader::keep(const dxJointLanes *rows, unsigned begin, unsigned end) const {
    const dReal perStep = dRecip(m_step.stepSize);
    for (unsigned i = begin; i < end; ++i)
        for (unsigned lane = 0; lane < dxLanes::kCount; ++lane) {
            if (laneJoint(i, lane).isEmpty()) continue;
            dxJoint &joint = jointOf(laneJoint(i, lane));
            const dxJointPack &pack = m_plan.jointPacks()[i];
            for (unsigned k = 0; k < laneJoint(i, lane).rowCount; ++k)
                joint.lambda[k] = perStep * static_cast<dReal>(rows[pack.firstRow + k].impulse.lane[lane]);
            dxKeptJointForces::mark(joint, m_step.fastQuickStep->step(), laneJoint(i, lane).rowCount);
        }
}

void dxJointReader::giveFeedback(const dxJointLanes *rows) const {
    const dReal perStep = dRecip(m_step.stepSize);
    for (const unsigned place : m_plan.feedbackLanes()) {
        const dxJointPack &pack = m_plan.jointPacks()[place / dxLanes::kCount];
        const dxJoint &joint = jointOf(m_plan.laneJoints()[place]);
        dVector3 force = {}, torqueOnA = {}, torqueOnB = {};
        for (unsigned k = 0; k < pack.rowCount; ++k)
            addForce(rows[pack.firstRow + k], place % dxLanes::kCount, perStep, force, torqueOnA, torqueOnB);
        dJointFeedback &feedback = *joint.feedback;
        dCopyVector3(feedback.f1, force);
        dCopyVector3(feedback.t1, torqueOnA);
        if (joint.node[1].body == nullptr) continue;
        dCopyNegatedVector3(feedback.f2, force);
        dCopyVector3(feedback.t2, torqueOnB);
    }
}
