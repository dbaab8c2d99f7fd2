#include "dynamics/world_step/fast/dxRowResidual.h"

#include <algorithm>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxRowMatrix.h"

namespace {

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

// Sums are kept apart from what is read, so that they stay in registers.
void addForces(const dReal *rows, unsigned count, const double *forces, dxBodyVector &sum) {
    double a = sum.lane[0], b = sum.lane[1], c = sum.lane[2], d = sum.lane[3], e = sum.lane[4], f = sum.lane[5];
    for (unsigned row = 0; row < count; ++row, rows += kBodyAxes) {
        const double force = forces[row];
        a += rows[0] * force;
        b += rows[1] * force;
        c += rows[2] * force;
        d += rows[3] * force;
        e += rows[4] * force;
        f += rows[5] * force;
    }
    sum = {{a, b, c, d, e, f, 0, 0}};
}

void accelerate(const dxInverseMass &inverse, const dxBodyVector &motion, dxBodyVector &body) {
    const dxBodyVector force = body;
    for (unsigned k = 0; k < 3; ++k) {
        body.lane[k] = force.lane[k] * inverse.mass + motion.lane[k];
        const double *const row = inverse.inertia[k];
        body.lane[3 + k] = row[0] * force.lane[3] + row[1] * force.lane[4] + row[2] * force.lane[5] + motion.lane[3 + k];
    }
}

void addMotion(const dReal *rows, unsigned count, const dxBodyVector &motion, double *w) {
    for (unsigned row = 0; row < count; ++row, rows += kBodyAxes) {
        const double linear = rows[0] * motion.lane[0] + rows[1] * motion.lane[1] + rows[2] * motion.lane[2];
        const double angular = rows[3] * motion.lane[3] + rows[4] * motion.lane[4] + rows[5] * motion.lane[5];
        w[row] += linear + angular;
    }
}

}  // namespace

void dxFindRowResidual(const dxWorldStepProblem &problem, const dxInverseMass *inverseMasses, const dxBodyVector *motions, const double *forces,
                       dxBodyVector *bodies, double *w) {
    std::fill_n(bodies, problem.bodyCount, dxBodyVector{});
    const auto forSides = [&problem](const auto &visit) {
        for (unsigned i = 0; i < problem.jointCount; ++i)
            for (unsigned side = 0; side < dxWorldStepProblem::kSides; ++side) {
                const dxBody *const body = problem.joints[i].joint->node[side].body;
                if (body != nullptr) visit(problem.joints[i], problem.rowsOf(problem.joints[i], side), static_cast<unsigned>(body->tag));
            }
    };
    forSides([&](const dxWorldStepJoint &joint, const dReal *rows, unsigned body) {
        addForces(rows, joint.rows, forces + joint.firstRow, bodies[body]);
    });
    for (unsigned i = 0; i < problem.bodyCount; ++i) accelerate(inverseMasses[i], motions[i], bodies[i]);
    for (unsigned row = 0; row < problem.rowCount; ++row) {
        const dReal *const pair = problem.pairsBX + std::size_t(row) * kPair;
        w[row] = double(pair[dxJoint::GI2_CFM]) * forces[row] - pair[dxJoint::GI2_RHS];
    }
    forSides([&](const dxWorldStepJoint &joint, const dReal *rows, unsigned body) {
        addMotion(rows, joint.rows, bodies[body], w + joint.firstRow);
    });
}
