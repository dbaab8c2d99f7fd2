// Kernels over packs of contacts (dxContactPack.h), for every instruction set. The numbers of a lane go through the same operations on all of
// them, and products and sums stay separate, so that results do not depend on the width of vectors.
//
// Each kernel writes an energy for each manifold, and returns the sum of them over manifolds.
//
// Threading: packs [begin, end) of one colour share no moving body with other packs of that colour, so several threads may take some each.
#pragma once

#include "dynamics/quick_step/fast/dxContactPack.h"
#include "dynamics/step/islands/dxIslandProblem.h"

// Completes what dxContactReader has written: tangents where none are given (direction[kTangent] is zero), couplings, effective masses,
// responses (if there is room for them), and impulses as projections of `impulse`, which holds a vector of the world. Energies: of the residual of
// the normals without impulses, `velocities` being the free ones.
double dxPrepareContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxSpatialMotion *velocities);

// Adds the impulses p to the velocities u. Energies: by how much that raises 1/2 u' M u + 1/2 p' softness p - bias' p, which is smallest for the
// solution.
double dxApplyImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSpatialMotion *velocities);

// Adds the impulses p to velocities in dReal. Sweeps leave velocities that differ from these by roundings of floats: momentum is conserved, and
// forces explain motions, to the precision of dReal here.
void dxAddImpulses(const dxContactPacks &contacts, unsigned begin, unsigned end, const dxIslandBody *masses, dxSpatialMotion *velocities);

// Factors by which an impulse changes more than its own row asks for.
struct dxOverRelaxation {
    dReal normal, friction;
};

// A sweep of projected Gauss-Seidel goes over the packs once, or three times (docs/fast.md, "The sweeps").
enum class dxSweepPart : unsigned {
    AllRows,       // of each contact the normal, then friction; all contacts of a manifold, twice
    Normals,       // the normals of a manifold, twice; all rows where a manifold has a single contact
    EvenFriction,  // tangents of the contacts 0, 2, ... of each manifold of two or more
    OddFriction,   // tangents of the contacts 1, 3, ...
};

constexpr bool dxIsFirst(dxSweepPart part) { return part == dxSweepPart::AllRows || part == dxSweepPart::Normals; }

// Energies: of the change, the sum of |change of an impulse x its residual|. The first part of a sweep sets them, others add to them.
double dxSweepContacts(const dxContactPacks &contacts, unsigned begin, unsigned end, dxSweepPart part, const dxOverRelaxation &factor,
                       dxSpatialMotion *velocities);
