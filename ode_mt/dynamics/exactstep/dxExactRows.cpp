#include "dynamics/exactstep/dxExactRows.h"

#include <ode/odemath.h>

#include <algorithm>

#include "dynamics/exactstep/dxExactProblem.h"

namespace {

constexpr unsigned kMatrixAlignment = 64;  // bytes
constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;
static_assert(kPair == int(dxJoint::GI2__LO_HI_MAX), "joints are told one distance for pairs of both kinds");

void takeJacobian(dxWorldProcessMemArena &arena, dxExactProblem &problem) {
    const std::size_t rows = problem.rowCount;
    problem.normalOf = arena.AllocateArray<int>(rows);
    problem.jacobian = arena.AllocateArray<dReal>(rows * dxExactProblem::kSides * dxExactProblem::kElements);
}

void takePairs(dxWorldProcessMemArena &arena, dxExactProblem &problem) {
    const std::size_t rows = problem.rowCount;
    problem.pairsBX = arena.AllocateArray<dReal>(rows * kPair);
    problem.pairsLoHi = arena.AllocateArray<dReal>(rows * kPair);
    problem.links.first = arena.AllocateArray<unsigned>(problem.bodyCount);
    problem.links.next = arena.AllocateArray<unsigned>(std::size_t(problem.jointCount) * dxExactProblem::kSides);
}

// What joints find before they write.
void clearRows(const dxExactProblem &problem, dReal cfm) {
    const std::size_t rows = problem.rowCount;
    std::fill_n(problem.jacobian, rows * dxExactProblem::kSides * dxExactProblem::kElements, dReal(0));
    for (std::size_t i = 0; i < rows; ++i) {
        problem.pairsBX[i * kPair + dxJoint::GI2_RHS] = 0;
        problem.pairsBX[i * kPair + dxJoint::GI2_CFM] = cfm;
        problem.pairsLoHi[i * kPair + dxJoint::GI2_LO] = -dInfinity;
        problem.pairsLoHi[i * kPair + dxJoint::GI2_HI] = dInfinity;
        problem.normalOf[i] = -1;
    }
}

void askJoints(const dxIslandStep &step, const dxExactProblem &problem) {
    clearRows(problem, step.world->global_cfm);
    const dReal framesPerSecond = dRecip(step.stepSize), erp = step.world->global_erp;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxExactJoint &joint = problem.joints[i];
        const std::size_t row = joint.firstRow;
        int *const normalOf = problem.normalOf + row;
        joint.joint->getInfo2(framesPerSecond, erp, dxExactProblem::kElements, problem.rowsOf(joint, dJCB_FIRST_BODY),
                              problem.rowsOf(joint, dJCB_SECOND_BODY), kPair, problem.pairsBX + row * kPair,
                              problem.pairsLoHi + row * kPair, normalOf);
        // Joints count from their own first row.
        for (unsigned k = 0; k < joint.rows; ++k)
            if (normalOf[k] != -1) normalOf[k] += static_cast<int>(row);
    }
    for (std::size_t i = 0; i < std::size_t(problem.rowCount) * kPair; ++i) problem.pairsBX[i] *= framesPerSecond;
}

}  // namespace

void dxTakeMatrix(dxWorldProcessMemArena &arena, dxExactProblem &problem) {
    problem.matrix = arena.AllocateOveralignedArray<dReal>(std::size_t(problem.rowCount) * dPAD(problem.rowCount), kMatrixAlignment);
}

void dxReadRows(const dxIslandStep &step, dxExactProblem &problem) {
    takeJacobian(*step.arena, problem);
    dxTakeMatrix(*step.arena, problem);
    takePairs(*step.arena, problem);
    askJoints(step, problem);
}

void dxReadRowsAlone(const dxIslandStep &step, dxExactProblem &problem) {
    takeJacobian(*step.arena, problem);
    takePairs(*step.arena, problem);
    askJoints(step, problem);
}
