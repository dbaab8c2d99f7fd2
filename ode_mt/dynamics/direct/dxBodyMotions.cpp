#include "dynamics/direct/dxBodyMotions.h"

#include <algorithm>
#include <cmath>

#include "dynamics/exactstep/dxExactProblem.h"

void dxFindBodyMotions(const dxExactProblem &problem, double stepSize, dxBodyVectors &motions) {
    motions.resize(problem.bodyCount);
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        const dxBody &body = *problem.bodies[i];
        const dReal *const tensor = problem.inverseInertia[i].tensor;
        dxBodyVector &motion = motions[i];
        motion = {};
        for (unsigned axis = 0; axis < 3; ++axis) {
            motion.lane[axis] = double(body.facc[axis]) * body.invMass + body.lvel[axis] / stepSize;
            motion.lane[3 + axis] = double(tensor[4 * axis]) * body.tacc[0] + double(tensor[4 * axis + 1]) * body.tacc[1] +
                                    double(tensor[4 * axis + 2]) * body.tacc[2] + body.avel[axis] / stepSize;
        }
    }
}

double dxLargestMotion(const dxExactProblem &problem, const dxBodyVectors &motions) {
    double largest = 0;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxExactJoint &joint = problem.joints[i];
        for (unsigned row = 0; row < joint.rows; ++row) {
            double sum = 0;
            for (unsigned side = 0; side < dxExactProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
                const dReal *const elements = problem.rowsOf(joint, side) + std::size_t(row) * dxExactProblem::kElements;
                const dxBodyVector &motion = motions[joint.joint->node[side].body->tag];
                for (unsigned k = 0; k < kBodyAxes; ++k) sum += std::fabs(elements[k] * motion.lane[k]);
            }
            largest = std::max(largest, sum);
        }
    }
    return largest;
}

bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxExactProblem &problem,
                      const dxBodyVectors &motions) {
    const auto isGoodBeside = [&](double all) { return residual <= bound.ofB * b + bound.ofSum * all; };
    return isGoodBeside(sum) || isGoodBeside(sum + dxLargestMotion(problem, motions));
}
