#include "dynamics/direct/dxBodyMotions.h"

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
