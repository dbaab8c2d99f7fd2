// Which rows of an island have no limits, neither fixed ones nor those of a normal's force.
#pragma once

#include <cstddef>

#include "dynamics/world_step/dxWorldStepProblem.h"

inline bool dxIsWithoutLimits(const dxWorldStepProblem &problem, std::size_t row) {
    const dReal *const limits = problem.pairsLoHi + row * dxJoint::GI2__LO_HI_MAX;
    return limits[dxJoint::GI2_LO] == -dInfinity && limits[dxJoint::GI2_HI] == dInfinity && problem.normalOf[row] == -1;
}
