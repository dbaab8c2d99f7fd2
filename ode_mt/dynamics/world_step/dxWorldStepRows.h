// The second and the third stage of dWorldStep: joints are put in order, and each writes its rows.
//
// Joints whose rows are all bilateral come first, then those that have both kinds, then those whose rows are all unilateral, so that the solver finds
// most bilateral rows in front, where they are factorised at once. Within a kind the order is upstream's, which decides the order of sums.
#pragma once

#include "dynamics/step/islands/dxIslandStep.h"

struct dxWorldStepProblem;

// Asks each joint of the island for its number of rows. Fills in the problem's joints and its number of rows. Writes the joints'
// tags, which no stage here reads, but upstream's step of a later island may (settings/dxJointAttachment.h).
void dxOrderJoints(const dxIslandStep &step, dxWorldStepProblem &problem);

// Requires rows. Fills in the Jacobian, c/h and cfm/h in the places of b and x, limits, rows of normals, and the links; takes the
// memory of all that belongs to rows. Joints that push against a stop add to their bodies' facc and tacc.
void dxReadRows(const dxIslandStep &step, dxWorldStepProblem &problem);
