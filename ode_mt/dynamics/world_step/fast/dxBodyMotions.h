// What moves an island's bodies before its joints do: v/h + inv(M) f, a change of velocity per step size. In doubles, whatever dReal is.
#pragma once

#include <limits>

#include "dynamics/world_step/fast/dxBodyBlocks.h"

struct dxWorldStepProblem;

struct dxInverseMass;

// By tag.
void dxFindBodyMotions(const dxWorldStepProblem &problem, double stepSize, dxBodyVector *motions);
void dxFindInverseMasses(const dxWorldStepProblem &problem, dxInverseMass *inverseMasses);

// The largest sum of |J| |u| in a row: b is the rest of c/h and J u, and has their rounding. Where bodies fall together, that is more than a
// part of b.
double dxLargestMotion(const dxWorldStepProblem &problem, const dxBodyVector *motions);

// The residual that is good enough, as part of the largest b and of the largest sum.
struct dxResidualBound {
    double ofB, ofSum;
};

// After an elimination.
constexpr dxResidualBound kEliminationBound = {1e-12, 8 * std::numeric_limits<double>::epsilon()};

// Whether forces do what the rows ask for, to a part of the largest b. Hard rows may not have the excuse of large sums: where they repeat or
// contradict one another, forces of 1e16 b cancel out to rounding errors as large as b. Rows with a c do have forces of up to b/c;
// `softSum` is the largest sum of theirs (dxDirectProblem::isSoft).
bool dxIsAnswer(double residual, double b, double softSum, const dxWorldStepProblem &problem, const dxBodyVector *motions);

// The largest residual, b and sum of the rows. Bodies that fall together have a b that is a small difference of large numbers: where the sum alone
// does not explain the residual, their motion is added to it.
bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxWorldStepProblem &problem,
                      const dxBodyVector *motions);
