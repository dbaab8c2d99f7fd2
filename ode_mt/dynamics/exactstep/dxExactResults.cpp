#include "dynamics/exactstep/dxExactResults.h"

#include <ode/odemath.h>

#include <algorithm>

#include "dynamics/exactstep/dxExactProblem.h"
#include "dynamics/exactstep/kernels/dxPair.h"
#include "dynamics/islands/dxBodyIntegration.h"

namespace {

constexpr unsigned kElements = dxExactProblem::kElements;
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
Force findForce(const dxExactProblem &problem, const dxExactJoint &joint, unsigned side) {
    const dReal *row = problem.rowsOf(joint, side);
    const dReal *lambda = problem.pairsBX + std::size_t(joint.firstRow) * kPair + kLambda;
    Force force;
    for (unsigned i = joint.rows; i > 0; --i, row += kElements, lambda += kPair) force.addRow(row, *lambda);
    return force;
}

// The sum over the body's joints. Writes their feedback.
void addUpForces(const dxExactProblem &problem, unsigned link, dReal *elements) {
    Force sum;
    for (; link != dxBodyLinks::kNone; link = problem.links.after(link)) {
        const dxExactJoint &joint = problem.joints[dxBodyLinks::jointOf(link)];
        const unsigned side = dxBodyLinks::sideOf(link);
        const Force force = findForce(problem, joint, side);
        if (joint.joint->feedback != nullptr) {
            force.store(elements);
            writeFeedback(*joint.joint->feedback, side, elements);
        }
        sum.add(force);
    }
    sum.store(elements);
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

}  // namespace

void dxApplyResults(const dxIslandStep &step, const dxExactProblem &problem) {
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        dxBody &body = *problem.bodies[i];
        const unsigned link = problem.links.first != nullptr ? problem.links.first[i] : dxBodyLinks::kNone;
        dReal sum[kElements];
        if (link != dxBodyLinks::kNone) addUpForces(problem, link, sum);
        accelerate(body, problem.inverseInertia[i].tensor, link != dxBodyLinks::kNone ? sum : nullptr, step.stepSize);
        dxIntegrateIslandBody(&body, step.stepSize);
        dZeroVector3(body.facc);
        dZeroVector3(body.tacc);
    }
}
