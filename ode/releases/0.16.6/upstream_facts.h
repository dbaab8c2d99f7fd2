// What ode_mt/ has to know of this release's internal structures, under one name in each release.
#pragma once

#include <ode/objects.h>

#include "config.h"
#include "objects.h"
#include "util.h"

// Returns how many threads step islands at the same time, as the world's limits and its threading implementation allow.
inline unsigned dxIslandThreads(const dxWorld &world) { return world.calculateIslandIterationMaxThreadCount(); }

// Returns the call of a stepper that steps an island, and solves its LCP, on the calling thread alone.
inline dxStepperProcessingCallContext dxSerialStepperCall(dxWorld *world, dReal stepSize, dxWorldProcessMemArena *arena,
                                                          dxBody *const *bodies, dxJoint *const *joints) {
    return {world, stepSize, 1, 1, arena, bodies, joints};
}

// Returns the same call for a stepper that is to use the thread that makes it, and no other.
inline dxStepperProcessingCallContext dxOnThisThread(const dxStepperProcessingCallContext &call) {
    dxStepperProcessingCallContext alone = call;
    alone.m_stepperAllowedThreads = alone.m_lcpAllowedThreads = 1;
    return alone;
}

// Returns the world's limit of threads that step one island; dWORLDSTEP_THREADCOUNT_UNLIMITED: none.
inline unsigned dxIslandSteppingLimit(const dxWorld &world) { return world.stepping_max_threads; }
