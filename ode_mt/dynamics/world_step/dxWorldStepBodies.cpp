#include "dynamics/world_step/dxWorldStepBodies.h"

#include <ode/odemath.h>

#include <algorithm>
#include <cfenv>

#include "dynamics/step/islands/dxBodyForces.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/kernels/dxBodyColumns.h"

namespace {

constexpr unsigned kInertiaAlignment = 32;  // bytes

// Fewer fill no vector.
constexpr unsigned kMinLaneBodies = 8;

void fill(dxInertiaColumns &columns, unsigned lane, const dxBody &body) {
    for (unsigned row = 0; row < 3; ++row) {
        columns.velocity[row][lane] = body.avel[row];
        for (unsigned column = 0; column < 3; ++column) {
            const unsigned from = 4 * row + column, to = 3 * row + column;
            columns.rotation[to][lane] = body.posr.R[from];
            columns.tensor[to][lane] = body.mass.I[from];
            columns.inverseTensor[to][lane] = body.invI[from];
        }
    }
}

void take(const dxInertiaColumns &columns, unsigned lane, dxBody &body, dReal *inverse) {
    for (unsigned row = 0; row < 3; ++row)
        for (unsigned column = 0; column < 3; ++column) inverse[4 * row + column] = columns.inverse[3 * row + column][lane];
    if ((body.flags & dxBodyGyroscopic) == 0 || !(body.invMass > 0) || columns.determinant[lane] == 0) return;
    for (unsigned axis = 0; axis < 3; ++axis) body.tacc[axis] += columns.torque[axis][lane];
}

void gatherInLanes(const dxIslandStep &step, const dxWorldStepProblem &problem) {
    dxInertiaColumns columns;
    for (unsigned begin = 0; begin < problem.bodyCount; begin += kBodyColumns) {
        dxBody *const *const bodies = problem.bodies + begin;
        const unsigned count = std::min(problem.bodyCount - begin, kBodyColumns);
        for (unsigned i = 0; i < dxFilledColumns(count); ++i) fill(columns, i, *bodies[std::min(i, count - 1)]);
        dxFindInertia(columns, count, step.stepSize);
        for (unsigned i = 0; i < count; ++i) {
            dxBody &body = *bodies[i];
            body.tag = static_cast<int>(begin + i);
            dxAddGravity(body, step.world->gravity);
            take(columns, i, body, problem.inverseInertia[begin + i].tensor);
        }
    }
}

}  // namespace

bool dxAreBodiesForLanes(const dxIsland &island) { return island.bodyCount >= kMinLaneBodies && fegetexcept() == 0; }

void dxGatherBodies(const dxIslandStep &step, dxWorldStepProblem &problem, bool inLanes) {
    problem.bodies = step.island.bodies;
    problem.bodyCount = step.island.bodyCount;
    problem.inverseInertia =
        step.arena->AllocateOveralignedArray<dxInverseInertia>(problem.bodyCount, kInertiaAlignment);
    if (inLanes) return gatherInLanes(step, problem);
    const dReal *const gravity = step.world->gravity;
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        dxBody &body = *problem.bodies[i];
        body.tag = static_cast<int>(i);
        dxAddGravity(body, gravity);
        dxFindInvInertia(body, problem.inverseInertia[i].tensor);
        dxAddGyroscopicTorque(body, step.stepSize);
    }
}
