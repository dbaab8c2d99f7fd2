// Eliminates the rows without limits of an island (dxRowBlocks.h): A_uu = L D L', left-looking, a block column for each joint, and with it
//
//   A_ll - A_lu inv(A_uu) A_ul  and  b_l - A_lu inv(A_uu) b_u
//
// the matrix and the right-hand side of the rows with limits alone (Schur complement). The right-hand side is treated as one more row.
// Source: Golub and Van Loan, "Matrix Computations", 4.2; Cottle, Pang and Stone, "The Linear Complementarity Problem", 2.3 (a principal
// pivotal transform leaves the complementarity problem of the other rows).
//
// Bits do not depend on the instruction set: lanes are columns, and each element is one sum in one order, with products and sums
// apart (-ffp-contract=off).
//
// Threading: one island, one thread.
#pragma once

#include "dynamics/world_step/fast/dxBodyBlocks.h"

struct dxRowBlocks;

// Returns false where a pivot is none, or small beside the diagonal's element: the rows repeat one another.
bool dxEliminateRows(dxRowBlocks &blocks);

// Requires rows, eliminated. `limited`: the forces of the rows with limits, lines as a row of A_ul, with -1 in the place of b. Writes the
// forces of the others, by place.
void dxSubstituteBack(const dxRowBlocks &blocks, const dxBodyVector *limited, dxBodyVectors &forces);
