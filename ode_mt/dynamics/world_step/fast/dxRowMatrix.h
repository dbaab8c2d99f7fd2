// Makes the blocks of J inv(M) J' from the Jacobian, and subtracts J u from the right-hand side. Bits do not depend on the instruction
// set: lanes are rows of a joint, and each element is one sum in one order.
#pragma once

#include "dynamics/world_step/fast/dxBodyBlocks.h"

struct dxRowBlocks;

// Of a body.
struct dxInverseMass {
    double mass;
    double inertia[3][3];
};

// Adds to the blocks, which hold cfm/h and c/h. `inverseMasses` and `motions` (u) by tag. Writes blocks.byMass.
void dxMakeRowMatrix(dxRowBlocks &blocks, const dxInverseMass *inverseMasses, const dxBodyVector *motions);
