// The second stage of the exact step: joints with rows are put in order. Those whose rows are all without limits come first,
// then those that have both kinds, then those whose rows all have limits, so that the solver finds most rows without limits in
// front, where they are factorised at once. Within a kind the order is upstream's, which decides the order of sums.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Asks each joint of the island for its number of rows. Fills in the problem's joints and its number of rows. Writes the joints'
// tags, which no stage here reads, but upstream's step of a later island may (settings/dxJointAttachment.h).
void dxOrderJoints(const dxIslandStep &step, dxWorldStepProblem &problem);
