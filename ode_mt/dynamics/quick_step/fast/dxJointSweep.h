// Kernels over packs of joints (dxJointPack.h), as those over packs of contacts (dxContactSweep.h): for every instruction set, with the same results.
//
// Threading: packs [begin, end) of one colour share no moving body with other packs of that colour, so several threads may take some each.
#pragma once

#include "dynamics/quick_step/fast/dxJointPack.h"

// Completes what dxJointReader has written: effective masses, and impulses within the limits. Energies: of the residuals without impulses,
// `velocities` being the free ones.
double dxPrepareJoints(const dxJointPacks &joints, unsigned begin, unsigned end, const dxSpatialMotion *velocities);

// Adds the impulses to the velocities, with the energies of dxApplyImpulses.
double dxApplyJointImpulses(const dxJointPacks &joints, unsigned begin, unsigned end, dxSpatialMotion *velocities);

// Relaxes the rows of each joint in their order, with an over-relaxation. Energies: of the change, the sum of |change of an impulse x its residual|.
double dxSweepJoints(const dxJointPacks &joints, unsigned begin, unsigned end, dReal factor, dxSpatialMotion *velocities);

// Adds the impulses to velocities in dReal (dxAddImpulses).
void dxAddJointImpulses(const dxJointPacks &joints, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities);
