#include "dynamics/world_step/fast/dxBodyMotions.h"

#include <algorithm>
#include <cmath>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/fast/dxRowMatrix.h"

namespace {

// The residual of an answer, as part of the largest b and of sums.
constexpr double kAnswerPart = sizeof(dReal) == sizeof(double) ? 1e-6 : 1e-2;
constexpr double kRoundings = 64 * std::numeric_limits<dReal>::epsilon();

}  // namespace

void dxFindBodyMotions(const dxWorldStepProblem &problem, double stepSize, dxBodyVector *motions) {
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

void dxFindInverseMasses(const dxWorldStepProblem &problem, dxInverseMass *inverseMasses) {
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        inverseMasses[i].mass = problem.bodies[i]->invMass;
        for (unsigned row = 0; row < 3; ++row)
            for (unsigned column = 0; column < 3; ++column)
                inverseMasses[i].inertia[row][column] = problem.inverseInertia[i].tensor[4 * row + column];
    }
}

double dxLargestMotion(const dxWorldStepProblem &problem, const dxBodyVector *motions) {
    double largest = 0;
    for (unsigned i = 0; i < problem.jointCount; ++i) {
        const dxWorldStepJoint &joint = problem.joints[i];
        for (unsigned row = 0; row < joint.rows; ++row) {
            double sum = 0;
            for (unsigned side = 0; side < dxWorldStepProblem::kSides && joint.joint->node[side].body != nullptr; ++side) {
                const dReal *const elements = problem.rowsOf(joint, side) + std::size_t(row) * dxWorldStepProblem::kElements;
                const dxBodyVector &motion = motions[joint.joint->node[side].body->tag];
                for (unsigned k = 0; k < kBodyAxes; ++k) sum += std::fabs(elements[k] * motion.lane[k]);
            }
            largest = std::max(largest, sum);
        }
    }
    return largest;
}

bool dxIsAnswer(double residual, double b, double softSum, const dxWorldStepProblem &problem, const dxBodyVector *motions) {
    const auto isAnswerBeside = [&](double all) { return residual <= kAnswerPart * b + kRoundings * all; };
    return isAnswerBeside(softSum) || isAnswerBeside(softSum + dxLargestMotion(problem, motions));
}

bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxWorldStepProblem &problem,
                      const dxBodyVector *motions) {
    const auto isGoodBeside = [&](double all) { return residual <= bound.ofB * b + bound.ofSum * all; };
    return isGoodBeside(sum) || isGoodBeside(sum + dxLargestMotion(problem, motions));
}
