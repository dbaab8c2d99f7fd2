/* The search for islands is ours (ode_mt/dynamics/dxIslandSearch.h). Upstream's is a static function in the same file as its
 * call, so the two are told apart by their first argument: a definition's begins with a type, a call's is a variable. */
#pragma once

#include "dynamics/dxIslandSearch.h"

#define BuildIslandsAndEstimateStepperMemoryRequirements(info, ...) dxIslandsSeam_##info, __VA_ARGS__)
#define dxIslandsSeam_dxWorldProcessIslandsInfo dxUpstreamFindIslands(dxWorldProcessIslandsInfo
#define dxIslandsSeam_islandsInfo dxFindIslands(islandsInfo
