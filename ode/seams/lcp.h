/* The Dantzig solver's triangular solves: ode_mt/dynamics/world_step/kernels takes the place of two of its internal
 * headers, whose include guards are set here. */
#pragma once

#include "../../ode_mt/dynamics/world_step/kernels/dxSolveL1.h"

#define _ODE_FASTLSOLVE_IMPL_H_
#define solveL1Straight dxSolveL1Straight
#define _ODE_FASTLTSOLVE_IMPL_H_
#define solveL1Transposed dxSolveL1Transposed
