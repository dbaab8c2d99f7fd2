// Products of the Jacobian, row by row, and the matrix in body space, in chunks. Bits do not depend on the instruction set: lanes are
// directions of a body, and sums over lanes have one order (dxBodyLanes-inl.h). A body's sums are over its manifolds, in their order.
#pragma once

#include <vector>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/fast/dxProblemChunks.h"

class dxBlockFactor;
class dxEliminationOrder;
struct dxDirectProblem;

namespace dxRowProducts {

// result = J u
void multiply(const dxDirectProblem &problem, const dxProblemChunks::Rows &chunk, const dxBodyVectors &u, double *result);

// result = J' x
void multiplyTransposed(const dxDirectProblem &problem, const dxProblemChunks &chunks, const dxProblemChunks::Bodies &chunk,
                        const double *x, dxBodyVectors &result);

// result = M u or inv(M) u, for the blocks of one of the two
void multiplyBodies(const dxBodyBlocks &blocks, const dxProblemChunks::Bodies &chunk, const dxBodyVectors &u, dxBodyVectors &result);

// Columns of H = M + J' W J for the diagonal matrix W; rows with weight 0 are skipped.
void makeColumns(const dxDirectProblem &problem, const dxProblemChunks &chunks, const dxEliminationOrder &order, unsigned begin,
                 unsigned end, const double *weight, dxBlockFactor &factor);

}  // namespace dxRowProducts
