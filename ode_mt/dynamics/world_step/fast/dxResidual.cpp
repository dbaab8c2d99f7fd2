#include "dynamics/world_step/fast/dxResidual.h"

#include <algorithm>
#include <cmath>

#include "dynamics/world_step/dxWorldStepProblem.h"

namespace {

// The residual of an answer, as part of the largest b and of sums.
constexpr double kAnswerPart = sizeof(dReal) == sizeof(double) ? 1e-6 : 1e-2;
constexpr double kRoundings = 64 * std::numeric_limits<dReal>::epsilon();

constexpr int kPair = dxJoint::GI2__RHS_CFM_MAX;

void addMotion(const dReal *rows, unsigned count, const dxBodyVector &motion, double *w) {
    for (unsigned row = 0; row < count; ++row, rows += kBodyAxes) {
        const double linear = rows[0] * motion.lane[0] + rows[1] * motion.lane[1] + rows[2] * motion.lane[2];
        const double angular = rows[3] * motion.lane[3] + rows[4] * motion.lane[4] + rows[5] * motion.lane[5];
        w[row] += linear + angular;
    }
}

// The largest |J| |u| of a row.
double largestMotion(const dxWorldStepProblem &problem, const dxBodyVector *motions) {
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

}  // namespace

void dxFindBodyMotions(const dxWorldStepProblem &problem, double stepSize, dxBodyVector *motions, dxPerStep perStep) {
    const double perSecond = 1 / stepSize;
    const auto divide = [=](double velocity) { return perStep == dxPerStep::Product ? velocity * perSecond : velocity / stepSize; };
    for (unsigned i = 0; i < problem.bodyCount; ++i) {
        const dxBody &body = *problem.bodies[i];
        const dReal *const tensor = problem.inverseInertia[i].tensor;
        dxBodyVector &motion = motions[i];
        motion = {};
        for (unsigned axis = 0; axis < 3; ++axis) {
            motion.lane[axis] = double(body.facc[axis]) * body.invMass + divide(body.lvel[axis]);
            motion.lane[3 + axis] = double(tensor[4 * axis]) * body.tacc[0] + double(tensor[4 * axis + 1]) * body.tacc[1] +
                                    double(tensor[4 * axis + 2]) * body.tacc[2] + divide(body.avel[axis]);
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
        dxAddForces(rows, joint.rows, forces + joint.firstRow, bodies[body]);
    });
    for (unsigned i = 0; i < problem.bodyCount; ++i) bodies[i] = dxAccelerate(inverseMasses[i], bodies[i], motions[i]);
    for (unsigned row = 0; row < problem.rowCount; ++row) {
        const dReal *const pair = problem.pairsBX + std::size_t(row) * kPair;
        w[row] = double(pair[dxJoint::GI2_CFM]) * forces[row] - pair[dxJoint::GI2_RHS];
    }
    forSides([&](const dxWorldStepJoint &joint, const dReal *rows, unsigned body) {
        addMotion(rows, joint.rows, bodies[body], w + joint.firstRow);
    });
}

bool dxIsAnswer(double residual, double b, double softSum, const dxWorldStepProblem &problem, const dxBodyVector *motions) {
    const auto isAnswerBeside = [&](double all) { return residual <= kAnswerPart * b + kRoundings * all; };
    return isAnswerBeside(softSum) || isAnswerBeside(softSum + largestMotion(problem, motions));
}

bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxWorldStepProblem &problem,
                      const dxBodyVector *motions) {
    const auto isGoodBeside = [&](double all) { return residual <= bound.ofB * b + bound.ofSum * all; };
    return isGoodBeside(sum) || isGoodBeside(sum + largestMotion(problem, motions));
}
