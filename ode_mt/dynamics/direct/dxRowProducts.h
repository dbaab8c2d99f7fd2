// Products of the Jacobian, row by row, and the matrix in body space. Bits do not depend on the instruction set: lanes are directions of
// a body, and sums over lanes have one order (dxBodyLanes-inl.h).
#pragma once

#include <vector>

#include "dynamics/direct/dxBodyBlocks.h"

class dxBlockFactor;
struct dxDirectProblem;

namespace dxRowProducts {

// result = J u
void multiply(const dxDirectProblem &problem, const dxBodyVectors &u, std::vector<double> &result);

// result = J' x
void multiplyTransposed(const dxDirectProblem &problem, const std::vector<double> &x, dxBodyVectors &result);

// result = M u or inv(M) u, for the blocks of one of the two
void multiplyBodies(const dxBodyBlocks &blocks, const dxBodyVectors &u, dxBodyVectors &result);

// H = M + J' W J for the diagonal matrix W; rows with weight 0 are skipped.
void makeMatrix(const dxDirectProblem &problem, const std::vector<double> &weight, dxBlockFactor &factor);

}  // namespace dxRowProducts
