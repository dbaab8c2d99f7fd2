#include "dynamics/world_step/exact/dxDantzigSolver.h"

#include <ode/odemath.h>

#include <cfenv>

#include "core/dxCacheLine.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dxDantzig.h"
#include "dynamics/world_step/exact/dxUpstreamLcp.h"
#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

namespace {

constexpr unsigned kElements = dxWorldStepProblem::kElements;
static_assert(kElements == kRowElements && dxWorldStepProblem::kSides == dxBodyLinks::kSides, "the kernel reads the Jacobian");
static_assert(dxConstraintMatrixTask::kInverseMass == dV3E_PAD && sizeof(dxInverseInertia) == 12 * sizeof(dReal),
              "the kernel reads tensors and the inverse mass beside them");
static_assert(int(dxJoint::GI2_RHS) == 0 && int(dxJoint::GI2_CFM) == 1 && int(dxJoint::GI2__RHS_CFM_MAX) == 2,
              "the kernel reads c/h and cfm/h");

}  // namespace

static_assert(int(dxJoint::GI2_RHS) == int(PBX_B) && int(dxJoint::GI2_CFM) == int(PBX_X) &&
                  int(dxJoint::GI2__RHS_CFM_MAX) == int(PBX__MAX),
              "joints write b where the solver reads it");
static_assert(int(dxJoint::GI2_LO) == int(PLH_LO) && int(dxJoint::GI2_HI) == int(PLH_HI) &&
                  int(dxJoint::GI2__LO_HI_MAX) == int(PLH__MAX),
              "joints write limits where the solver reads them");

bool dxDantzigSolver::solve(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    void *const state = step.arena->SaveState();
    solve(step, problem, dxMakeMatrix(step, problem));
    step.arena->RestoreState(state);
    return false;
}

// Upstream passes the number of bilateral joints where that of bilateral rows is meant, and ours does the same: the solver finds the other rows by
// their limits, and the order in which it looks at rows depends on that.
void dxDantzigSolver::solve(const dxIslandStep &step, const dxWorldStepProblem &problem, dReal *matrix) {
    dxSolveDantzig(step.islandWorkers, step.arena, problem.rowCount, matrix, problem.pairsBX, nullptr, problem.bilateralJoints,
                   problem.pairsLoHi, problem.normalOf);
}

void dxFindMotions(const dxWorldStepProblem &problem, dReal stepSize, dReal *motions) {
    const dReal framesPerSecond = dRecip(stepSize);
    dReal *motion = motions;
    for (unsigned i = 0; i < problem.bodyCount; ++i, motion += kElements) {
        const dxBody &body = *problem.bodies[i];
        dReal *const inverseInertia = problem.inverseInertia[i].tensor;
        for (unsigned axis = dSA__MIN; axis != dSA__MAX; ++axis)
            motion[dDA__L_MIN + axis] = body.facc[axis] * body.invMass + body.lvel[axis] * framesPerSecond;
        dMultiply0_331(motion + dDA__A_MIN, inverseInertia, body.tacc);
        for (unsigned axis = dSA__MIN; axis != dSA__MAX; ++axis)
            motion[dDA__A_MIN + axis] += body.avel[axis] * framesPerSecond;
        inverseInertia[dxConstraintMatrixTask::kInverseMass] = body.invMass;
    }
}

void dxListConstraintJoints(const dxWorldStepProblem &problem, dxConstraintJoint *list) {
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        const dxBody *const second = joint.joint->node[dJCB_SECOND_BODY].body;
        list[i] = {joint.firstRow, joint.rows,
                   {static_cast<unsigned>(joint.joint->node[dJCB_FIRST_BODY].body->tag),
                    second != nullptr ? static_cast<unsigned>(second->tag) : dxConstraintJoint::kNoBody}};
    }
}

dReal *dxMakeMatrix(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    dxWorldProcessMemArena &arena = *step.arena;
    const std::size_t rows = problem.rowCount;
    dReal *const matrix = arena.AllocateOveralignedArray<dReal>(rows * dPAD(rows), kCacheLine);
    void *const state = arena.SaveState();
    dxConstraintJoint *const joints = arena.AllocateArray<dxConstraintJoint>(problem.jointCount);
    dxListConstraintJoints(problem, joints);
    dReal *const motions = arena.AllocateArray<dReal>(std::size_t(problem.bodyCount) * kElements);
    dxFindMotions(problem, step.stepSize, motions);
    dxConstraintMatrixTask task;
    task.joints = joints;
    task.jointCount = problem.jointCount;
    task.jacobian = problem.jacobian;
    task.inverseInertia = problem.inverseInertia->tensor;
    task.motions = motions;
    task.pairs = problem.pairsBX;
    task.matrix = matrix;
    task.rowSkip = dPAD(rows);
    task.transposed = arena.AllocateArray<dReal>(dxConstraintMatrixTask::transposedSize(rows));
    task.links = problem.links;
    dxMakeConstraintMatrix(task, fegetexcept() == 0);
    arena.RestoreState(state);
    return matrix;
}
