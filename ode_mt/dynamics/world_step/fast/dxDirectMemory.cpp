#include "dynamics/world_step/fast/dxDirectMemory.h"

#include <algorithm>

#include "lcp.h"
#include "step.h"
#include "util.h"

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxDantzigTrial.h"
#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

namespace {

constexpr sizeint kAlignment = 64;  // of matrices and tensors, at most

template <class Element>
sizeint sizeOf(sizeint count) {
    return dOVERALIGNED_SIZE(count * sizeof(Element), kAlignment);
}

// Bodies, joints and rows.
sizeint sizeOfRows(sizeint bodies, sizeint joints, sizeint rows) {
    return sizeOf<dxInverseInertia>(bodies) + sizeOf<dxWorldStepJoint>(2 * joints) + sizeOf<int>(rows) +
           sizeOf<dReal>(rows * dxWorldStepProblem::kSides * dxWorldStepProblem::kElements) + 2 * sizeOf<dReal>(2 * rows) +
           sizeOf<unsigned>(bodies) + sizeOf<unsigned>(joints * dxWorldStepProblem::kSides);
}

// Of the matrix alone: small islands need not know more.
constexpr sizeint kLeastMatrix = sizeint(kMinDirectRows) * kMinDirectRows * sizeof(dReal);

// The matrix, and what makes and solves it.
sizeint sizeOfMatrix(sizeint bodies, sizeint joints, unsigned rows) {
    const sizeint making = sizeOf<dxConstraintJoint>(joints) + sizeOf<dReal>(bodies * dxWorldStepProblem::kElements) +
                           sizeOf<dReal>(dxConstraintMatrixTask::transposedSize(rows));
    return sizeOf<dReal>(sizeint(rows) * dPAD(rows)) + std::max(making, dxEstimateSolveLCPMemoryReq(rows, false));
}

}  // namespace

sizeint dxEstimateDirectStepMemory(dxBody *const *bodies, unsigned bodyCount, dxJoint *const *joints, unsigned jointCount) {
    const sizeint upstreams = dxEstimateStepMemoryRequirements(bodies, bodyCount, joints, jointCount);
    const sizeint trial = dxDantzigTrial::memory(bodyCount, std::min(kMaxJointRows * jointCount, kMinDirectRows));
    if (upstreams <= kLeastMatrix) return upstreams + trial;
    const sizeint matrix = sizeOfMatrix(bodyCount, jointCount, kMinDirectRows);
    if (upstreams <= matrix) return upstreams + trial;
    sizeint rows = 0;
    for (unsigned i = 0; i < jointCount; ++i) {
        dxJoint::SureMaxInfo info;
        joints[i]->getSureMaxInfo(&info);
        rows += info.max_m;
    }
    return std::min(upstreams, sizeOfRows(bodyCount, jointCount, rows) + matrix) + trial;
}
