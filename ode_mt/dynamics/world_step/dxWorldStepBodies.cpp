#include "dynamics/world_step/dxWorldStepBodies.h"

#include <ode/odemath.h>

#include <algorithm>
#include <cfenv>

#include "dynamics/step/islands/dxBodyForces.h"
#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/kernels/dxBodyColumns.h"
#include "dynamics/world_step/kernels/dxPair.h"
#include "threading/dxUpstreamScope.h"

namespace {

// --- the first stage -------------------------------------------------------------------------------------------

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

// --- the last stage --------------------------------------------------------------------------------------------

constexpr unsigned kElements = dxWorldStepProblem::kElements;
constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX, kLambda = dxJoint::GI2_CFM;

void writeFeedback(dJointFeedback &feedback, unsigned side, const dReal *force) {
    dReal *const linear = side == dJCB_FIRST_BODY ? feedback.f1 : feedback.f2;
    dReal *const angular = side == dJCB_FIRST_BODY ? feedback.t1 : feedback.t2;
    std::copy_n(force + dDA__L_MIN, dSA__MAX, linear);
    std::copy_n(force + dDA__A_MIN, dSA__MAX, angular);
}

// A force and a torque on a body.
struct Force {
    dxPair a = {}, b = {}, c = {};

    void add(const Force &other) {
        a += other.a;
        b += other.b;
        c += other.c;
    }
    void addRow(const dReal *row, dReal lambda) {
        a += dxLoadPair(row) * lambda;
        b += dxLoadPair(row + 2) * lambda;
        c += dxLoadPair(row + 4) * lambda;
    }
    void store(dReal *elements) const {
        dxStorePair(a, elements);
        dxStorePair(b, elements + 2);
        dxStorePair(c, elements + 4);
    }
};

// J' x of one joint on one of its bodies.
Force findForce(const dxWorldStepProblem &problem, const dxWorldStepJoint &joint, unsigned side) {
    const dReal *row = problem.rowsOf(joint, side);
    const dReal *lambda = problem.pairsBX + std::size_t(joint.firstRow) * kPair + kLambda;
    Force force;
    for (unsigned i = joint.rows; i > 0; --i, row += kElements, lambda += kPair) force.addRow(row, *lambda);
    return force;
}

// The sum over the body's joints. Writes their feedback, if `tells`. Returns whether there is some.
bool addUpForces(const dxWorldStepProblem &problem, unsigned link, dReal *elements, bool tells) {
    Force sum;
    bool hasFeedback = false;
    for (; link != dxBodyLinks::kNone; link = problem.links.after(link)) {
        const dxWorldStepJoint &joint = problem.joints[dxBodyLinks::jointOf(link)];
        const unsigned side = dxBodyLinks::sideOf(link);
        const Force force = findForce(problem, joint, side);
        if (joint.joint->feedback != nullptr) {
            hasFeedback = true;
            force.store(elements);
            if (tells) writeFeedback(*joint.joint->feedback, side, elements);
        }
        sum.add(force);
    }
    sum.store(elements);
    return hasFeedback;
}

// A body that no row holds has no sum: to add a zero could change the sign of another one.
void accelerate(dxBody &body, const dReal *inverseInertia, const dReal *sum, dReal stepSize) {
    const dReal linearScale = stepSize * body.invMass;
    dVector3 impulse;
    if (sum != nullptr) {
        for (unsigned axis = dSA__MIN; axis != dSA__MAX; ++axis) {
            body.lvel[axis] += (sum[dDA__L_MIN + axis] + body.facc[axis]) * linearScale;
            impulse[axis] = (sum[dDA__A_MIN + axis] + body.tacc[axis]) * stepSize;
        }
    } else {
        dAddVectorScaledVector3(body.lvel, body.lvel, body.facc, linearScale);
        dCopyScaledVector3(impulse, body.tacc, stepSize);
    }
    dMultiplyAdd0_331(body.avel, inverseInertia, impulse);
}

// Writes feedback, if `tells`. Returns whether there is some.
bool accelerateBody(const dxIslandStep &step, const dxWorldStepProblem &problem, unsigned index, bool areForcesApplied, bool tells = true) {
    const bool hasRows = problem.links.first != nullptr && !areForcesApplied;
    const unsigned link = hasRows ? problem.links.first[index] : dxBodyLinks::kNone;
    dReal sum[kElements];
    const bool hasFeedback = link != dxBodyLinks::kNone && addUpForces(problem, link, sum, tells);
    accelerate(*problem.bodies[index], problem.inverseInertia[index].tensor, link != dxBodyLinks::kNone ? sum : nullptr, step.stepSize);
    return hasFeedback;
}

void moveAlone(const dxIslandStep &step, const dxWorldStepProblem &problem, unsigned index, bool areForcesApplied) {
    dxBody &body = *problem.bodies[index];
    accelerateBody(step, problem, index, areForcesApplied);
    dxIntegrateIslandBody(&body, step.stepSize);
    dxClearForces(body);
}

// --- in lanes ----------------------------------------------------------------------------------------------

void limitTurn(dxBody &body) {
    if ((body.flags & dxBodyMaxAngularSpeed) == 0) return;
    const dReal most = body.max_angular_speed, square = dCalcVectorDot3(body.avel, body.avel);
    if (square > most * most) dScaleVector3(body.avel, most / dSqrt(square));
}

void damp(dxBody &body) {
    const auto slow = [](dReal *velocity, dReal threshold, dReal scale) {
        if (dCalcVectorDot3(velocity, velocity) > threshold) dScaleVector3(velocity, 1 - scale);
    };
    if ((body.flags & dxBodyLinearDamping) != 0) slow(body.lvel, body.dampingp.linear_threshold, body.dampingp.linear_scale);
    if ((body.flags & dxBodyAngularDamping) != 0) slow(body.avel, body.dampingp.angular_threshold, body.dampingp.angular_scale);
}

void fill(dxTurnColumns &columns, unsigned lane, const dxBody &body) {
    for (unsigned axis = 0; axis < 3; ++axis) columns.velocity[axis][lane] = body.avel[axis];
    for (unsigned k = 0; k < 4; ++k) columns.orientation[k][lane] = body.q[k];
}

void take(const dxTurnColumns &columns, unsigned lane, dxBody &body) {
    for (unsigned k = 0; k < 4; ++k) body.q[k] = columns.orientation[k][lane];
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 3; ++column) body.posr.R[4 * row + column] = columns.rotation[3 * row + column][lane];
        body.posr.R[4 * row + 3] = 0;
    }
}

struct Velocity {
    dReal linear[3], angular[3];
};

// Returns false where a body does not move quietly; none of them has changed then, and no feedback.
bool accelerateQuietly(const dxIslandStep &step, const dxWorldStepProblem &problem, unsigned begin, unsigned end, bool areForcesApplied) {
    Velocity before[kBodyColumns];
    bool isQuiet = true, hasFeedback = false;
    for (unsigned i = begin; i < end; ++i) {
        const dxBody &body = *problem.bodies[i];
        std::copy_n(body.lvel, 3, before[i - begin].linear);
        std::copy_n(body.avel, 3, before[i - begin].angular);
        hasFeedback |= accelerateBody(step, problem, i, areForcesApplied, false);
        isQuiet &= dxMayDeferNotification(body);
    }
    dReal sum[kElements];
    for (unsigned i = begin; i < end && isQuiet && hasFeedback; ++i)
        if (problem.links.first[i] != dxBodyLinks::kNone) addUpForces(problem, problem.links.first[i], sum, true);
    for (unsigned i = begin; i < end && !isQuiet; ++i) {
        std::copy_n(before[i - begin].linear, 3, problem.bodies[i]->lvel);
        std::copy_n(before[i - begin].angular, 3, problem.bodies[i]->avel);
    }
    return isQuiet;
}

void turnInLanes(const dxIslandStep &step, unsigned begin, unsigned end) {
    dxBody *const *const bodies = step.island.bodies + begin;
    const unsigned count = end - begin;
    dxTurnColumns columns;
    for (unsigned i = 0; i < count; ++i) {
        limitTurn(*bodies[i]);
        fill(columns, i, *bodies[i]);
    }
    for (unsigned i = count; i < dxFilledColumns(count); ++i) fill(columns, i, *bodies[count - 1]);
    dxTurnBodies(columns, count, step.stepSize);
    for (unsigned i = 0; i < count; ++i) {
        dxBody &body = *bodies[i];
        for (unsigned axis = 0; axis < 3; ++axis) body.posr.pos[axis] += step.stepSize * body.lvel[axis];
        take(columns, i, body);
        damp(body);
        dxClearForces(body);
    }
}

void tellSpaces(const dxIsland &island, unsigned begin, unsigned end) {
    const dxUpstreamScope *const scope = dxUpstreamScope::current();
    if (scope != nullptr && scope->defersMoved()) return;
    dxIsland part = island;
    part.bodies += begin;
    part.bodyCount = end - begin;
    dxNotifyMoved(part);
}

// Spaces have heard of all bodies before one of which somebody else hears.
void applyInLanes(const dxIslandStep &step, const dxWorldStepProblem &problem, bool areForcesApplied) {
    unsigned told = 0;
    for (unsigned begin = 0; begin < problem.bodyCount; begin += kBodyColumns) {
        const unsigned end = std::min(begin + kBodyColumns, problem.bodyCount);
        if (accelerateQuietly(step, problem, begin, end, areForcesApplied)) {
            turnInLanes(step, begin, end);
            continue;
        }
        tellSpaces(step.island, told, begin);
        told = end;
        for (unsigned i = begin; i < end; ++i) moveAlone(step, problem, i, areForcesApplied);
    }
    tellSpaces(step.island, told, problem.bodyCount);
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

void dxApplyResults(const dxIslandStep &step, const dxWorldStepProblem &problem, bool areForcesApplied, bool inLanes) {
    if (inLanes && !(dxHasUserHandlers() && dxTouchesLockedSpace(step.island))) return applyInLanes(step, problem, areForcesApplied);
    for (unsigned i = 0; i < problem.bodyCount; ++i) moveAlone(step, problem, i, areForcesApplied);
}
