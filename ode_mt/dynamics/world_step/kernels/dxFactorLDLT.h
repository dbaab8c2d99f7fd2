// The factorisation of the exact step's bilateral rows: upstream's factorMatrixAsLDLT
// (ode/src/fastldltfactor_impl.h) with its bits. docs/exact.md tells how.
#pragma once

#include <ode/common.h>

#include <cstddef>

#include "dynamics/world_step/kernels/dxTriangle.h"

// Elements of storage, aligned to a cache line, for n rows.
std::size_t dxFactorLDLTStorage(unsigned n);

// A = L D L': the lower triangle of A, whose rows start rowSkip elements apart, becomes that of L below the diagonal;
// the diagonal itself, ones, is not written. d(i) = 1 / D(i). rowCount is at least 1. The skyline is that of A and of
// L: before it, A is +0. It is exact if everything is finite, and results are rounded to nearest.
void dxFactorLDLT(dReal *A, dReal *d, unsigned rowCount, unsigned rowSkip, const dxSkyline &skyline,
                  dReal *storage);
