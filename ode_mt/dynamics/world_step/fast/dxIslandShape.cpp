#include "dynamics/world_step/fast/dxIslandShape.h"

#include <algorithm>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"
#include "util.h"

#include "core/dxNoIndex.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxRowLimits.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

// Of a body, the joints so far that have rows without limits.
struct Share {
    unsigned firstRow;  // among rows without limits; kNoIndex: none
    unsigned joints;
};

// J (v/h + inv(M) f) of one row.
double findMotion(const dxWorldStepProblem &problem, const dxWorldStepJoint &joint, unsigned row, double stepSize) {
    double sum = 0;
    for (unsigned side = 0; side < dxWorldStepProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
        const dReal *const elements = problem.rowsOf(joint, side) + std::size_t(row) * dxWorldStepProblem::kElements;
        const dxBody &body = *joint.joint->node[side].body;
        const dReal *const tensor = problem.inverseInertia[body.tag].tensor;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const dReal *const inertia = tensor + 4 * axis;
            const double turn = double(inertia[0]) * body.tacc[0] + double(inertia[1]) * body.tacc[1] + double(inertia[2]) * body.tacc[2];
            sum += elements[axis] * (double(body.facc[axis]) * body.invMass + body.lvel[axis] / stepSize);
            sum += elements[3 + axis] * (turn + body.avel[axis] / stepSize);
        }
    }
    return sum;
}

}  // namespace

dxIslandShape dxIslandShape::of(const dxWorldStepProblem &problem, dxWorldProcessMemArena &arena) {
    dxIslandShape shape;
    shape.bodies = problem.bodyCount;
    shape.joints = problem.jointCount;
    shape.rows = problem.rowCount;
    void *const state = arena.SaveState();
    Share *const shares = arena.AllocateArray<Share>(problem.bodyCount);
    std::fill_n(shares, problem.bodyCount, Share{kNoIndex, 0});
    unsigned position = 0;  // among rows without limits
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        unsigned first = i < problem.unboundedJoints ? joint.rows : 0u, unlimited = first;
        for (unsigned row = first; row < joint.rows; ++row) {
            const bool isUnlimited = dxIsWithoutLimits(problem, std::size_t(joint.firstRow) + row);
            first += isUnlimited && unlimited == row;
            unlimited += isUnlimited;
        }
        shape.limited += joint.rows - unlimited;
        if (first == 0) continue;
        ++shape.eliminatedJoints;
        shape.eliminatedRows += first;
        unsigned begin = position;
        for (unsigned side = 0; side < dxWorldStepProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
            Share &share = shares[joint.joint->node[side].body->tag];
            if (share.firstRow == kNoIndex) share.firstRow = position;
            begin = std::min(begin, share.firstRow);
            shape.blocks += share.joints;
            shape.products += double(share.joints) * (share.joints + 1) / 2;
            ++share.joints;
        }
        const double length = position - begin + first;
        shape.skyline += first * length;
        shape.skylineSquares += first * length * length;
        position += first;
    }
    arena.RestoreState(state);
    return shape;
}

double dxFindActiveShare(const dxWorldStepProblem &problem, double stepSize) {
    unsigned limited = 0, active = 0;
    int lastRow = -1;  // of those that push or pull only
    bool isLastActive = true;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        for (unsigned row = 0; row < joint.rows; ++row) {
            const std::size_t index = std::size_t(joint.firstRow) + row;
            if (dxIsWithoutLimits(problem, index)) continue;
            ++limited;
            const double low = problem.pairsLoHi[index * kPair + dxJoint::GI2_LO], high = problem.pairsLoHi[index * kPair + dxJoint::GI2_HI];
            bool isActive = true;
            if (problem.normalOf[index] != -1) {
                isActive = problem.normalOf[index] != lastRow || isLastActive;
            } else if ((low == 0) != (high == 0)) {
                const double b = problem.pairsBX[index * kPair + dxJoint::GI2_RHS] - findMotion(problem, joint, row, stepSize);
                isActive = low == 0 ? b > 0 : b < 0;
                lastRow = static_cast<int>(index);
                isLastActive = isActive;
            }
            active += isActive;
        }
    }
    return limited > 0 ? double(active) / limited : 0;
}
