#include "dynamics/direct/dxIslandShape.h"

#include <algorithm>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"
#include "util.h"

#include "core/dxNoIndex.h"
#include "dynamics/exactstep/dxExactProblem.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

// Of a body, the joints so far that have rows without limits.
struct Share {
    unsigned firstRow;  // among rows without limits; kNoIndex: none
    unsigned joints;
};

bool isWithoutLimits(const dxExactProblem &problem, std::size_t row) {
    const dReal *const limits = problem.pairsLoHi + row * kPair;
    return limits[dxJoint::GI2_LO] == -dInfinity && limits[dxJoint::GI2_HI] == dInfinity && problem.normalOf[row] == -1;
}

}  // namespace

dxIslandShape dxIslandShape::of(const dxExactProblem &problem, dxWorldProcessMemArena &arena) {
    dxIslandShape shape;
    shape.bodies = problem.bodyCount;
    shape.joints = problem.jointCount;
    shape.rows = problem.rowCount;
    void *const state = arena.SaveState();
    Share *const shares = arena.AllocateArray<Share>(problem.bodyCount);
    std::fill_n(shares, problem.bodyCount, Share{kNoIndex, 0});
    unsigned position = 0;  // among rows without limits
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxExactJoint &joint = problem.joints[i];
        unsigned first = i < problem.unboundedJoints ? joint.rows : 0u, unlimited = first;
        for (unsigned row = first; row < joint.rows; ++row) {
            const bool isUnlimited = isWithoutLimits(problem, std::size_t(joint.firstRow) + row);
            first += isUnlimited && unlimited == row;
            unlimited += isUnlimited;
        }
        shape.limited += joint.rows - unlimited;
        if (first == 0) continue;
        ++shape.eliminatedJoints;
        shape.eliminatedRows += first;
        unsigned begin = position;
        for (unsigned side = 0; side < dxExactProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
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
