// Kernels over packs of contacts (dxContactPack.h), for every instruction set. A lane's numbers go through the same operations on
// all of them, products and sums apart, so that results do not depend on the width of vectors.
//
// Threading: packs [begin, end) of one colour share no moving body with others of that colour.
#pragma once

#include "dynamics/iterative/dxContactPack.h"
#include "dynamics/iterative/dxVelocities.h"

// Completes what dxContactReader has written: tangents where none are given (direction[1] zero), couplings, inverses, responses (if there is room), impulses as
// projections of `impulse`, which holds a vector in the world's frame. Returns the energy of the residual without impulses, u
// being the free velocities.
double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities);

// Adds the impulses to the velocities.
void dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities);

// One sweep of projected Gauss-Seidel, over-relaxed by `factor`. Returns the energy of the change: the sum of |change of an
// impulse times its residual|.
double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dReal factor, dxVelocity *velocities);
