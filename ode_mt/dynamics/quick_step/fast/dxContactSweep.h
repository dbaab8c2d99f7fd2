// Kernels over packs of contacts (dxContactPack.h), for every instruction set. A lane's numbers go through the same operations on
// all of them, products and sums apart, so that results do not depend on the width of vectors.
//
// Each writes an energy for each manifold, and returns the sum of them over manifolds.
//
// Threading: packs [begin, end) of one colour share no moving body with others of that colour.
#pragma once

#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/quick_step/fast/dxVelocities.h"

// Completes what dxContactReader has written: tangents where none are given (direction[1] zero), couplings, inverses, responses (if there is room), impulses as
// projections of `impulse`, which holds a vector in the world's frame. Energies: of the residual without impulses, u being the free
// velocities.
double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxVelocity *velocities);

// Adds the impulses p to the velocities u. Energies: by how much that raises 1/2 u' M u + 1/2 p' softness p - wanted' p, which the
// solution makes least.
double dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxVelocity *velocities);

// By how much the change of an impulse exceeds what its own row asks for.
struct dxOverRelaxation {
    dReal pressure, friction;
};

// A sweep of projected Gauss-Seidel goes over the packs once, or three times (docs/iterative-solver.md, "Pressures first").
enum class dxSweepPart : unsigned {
    Contacts,      // all rows: of each contact the normal, then friction; a manifold's contacts twice in turn
    Pressures,     // normals alone, a manifold's twice in turn; all rows where a manifold has a single contact
    EvenFriction,  // tangents of the contacts 0, 2, ... of each manifold with two or more
    OddFriction,   // of 1, 3, ...
};

constexpr bool dxIsFirst(dxSweepPart part) { return part == dxSweepPart::Contacts || part == dxSweepPart::Pressures; }
constexpr bool dxIsLast(dxSweepPart part) { return part == dxSweepPart::Contacts || part == dxSweepPart::OddFriction; }

// Energies: of the change, the sum of |change of an impulse times its residual|; parts add theirs to those of the first one.
double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
                       dxVelocity *velocities);
