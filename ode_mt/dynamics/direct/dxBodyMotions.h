// What moves an island's bodies before its joints do: v/h + inv(M) f, a change of velocity per step size. In doubles, whatever dReal is.
#pragma once

#include <limits>

#include "dynamics/direct/dxBodyBlocks.h"

struct dxExactProblem;

// By tag.
void dxFindBodyMotions(const dxExactProblem &problem, double stepSize, dxBodyVectors &motions);

// The largest sum of |J| |u| in a row: b is the rest of c/h and J u, and has their rounding. Where bodies fall together, that is more than a
// part of b.
double dxLargestMotion(const dxExactProblem &problem, const dxBodyVectors &motions);

// The residual that is good enough, as part of the largest b and of the largest sum.
struct dxResidualBound {
    double ofB, ofSum;
};

// After an elimination.
constexpr dxResidualBound kEliminationBound = {1e-12, 8 * std::numeric_limits<double>::epsilon()};

// The largest residual, b and sum of the rows. Bodies that fall together have a b that is a small difference of large numbers: where the sum alone
// does not explain the residual, their motion is added to it.
bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxExactProblem &problem,
                      const dxBodyVectors &motions);
