// Kernels over packs of contacts (dxContactPack.h), for every instruction set. A lane's numbers go through the same operations on
// all of them, products and sums apart, so that results do not depend on the width of vectors.
//
// Each writes an energy for each manifold, and returns the sum of them over manifolds.
//
// Threading: packs [begin, end) of one colour share no moving body with others of that colour.
#pragma once

#include "dynamics/iterative/dxContactPack.h"
#include "dynamics/iterative/dxVelocities.h"

// Completes what dxContactReader has written: tangents where none are given (direction[1] zero), couplings, inverses, responses (if there is room), impulses as
// projections of `impulse`, which holds a vector in the world's frame. Energies: of the residual without impulses, u being the free
// velocities.
double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities);

// Adds the impulses p to the velocities u. Energies: by how much that raises 1/2 u' M u + 1/2 p' softness p - wanted' p, which the
// solution makes least.
double dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities);

// A sweep of projected Gauss-Seidel is these parts, each of all packs before the next one (docs/iterative-solver.md, "Pressures first").
enum class dxSweepPart : unsigned {
    Pressures,     // normals, each manifold's twice in turn
    EvenFriction,  // tangents of the contacts 0, 2, ... of each manifold
    OddFriction,   // of 1, 3, ...
};

// overRelaxation: by how much the change of an impulse exceeds what its own row asks for, 1: by nothing. Energies: of the change, the sum
// of |change of an impulse times its residual|, added to those of the parts before.
double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, dReal overRelaxation,
                       dxVelocity *velocities);
