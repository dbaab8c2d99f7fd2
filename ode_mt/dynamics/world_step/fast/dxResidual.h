// How far forces are from a solution of an island's problem, and whether that is good enough.
//
// A residual is computed from the rows that joints have written, and not from a matrix that was made or factorised: w = J (inv(M) J' x + u) +
// cfm/h x - c/h with u = v/h + inv(M) f, what moves the bodies before their joints do. A solution satisfies the conditions of Karush, Kuhn and
// Tucker (dxBodySpaceProblem.h); what is left of them is measured in units of w, a change of velocity per step size.
//
// All numbers are doubles, whatever dReal is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <ode/common.h>

#include "dynamics/world_step/fast/dxBodyBlocks.h"
#include "dynamics/world_step/kernels/dxPair.h"

struct dxWorldStepProblem;

// --- the conditions of one row --------------------------------------------------------------------------------

// Returns the residual of a row. Where it may not move at all, any w is right.
inline double dxKktResidual(double x, double w, double low, double high) {
    if (low == high) return 0;
    if (x <= low) return std::max(0.0, -w);
    if (x >= high) return std::max(0.0, w);
    return std::fabs(w);
}

// Returns x, or the limit if x is next to it, as rounding may leave it.
inline double dxSnapToLimit(double x, double low, double high) {
    constexpr double kNear = 1e-9;  // as part of the limit
    for (const double limit : {low, high})
        if (std::isfinite(limit) && std::fabs(x - limit) <= kNear * std::fabs(limit)) x = limit;
    return x;
}

// The residual of the worst row; infinity if a w is not finite, as it is where a force is not: a comparison may drop what is no number.
class dxWorstResidual {
public:
    void add(double residual, double w) {
        m_worst = std::max(m_worst, residual);
        m_zero += w * 0;
    }
    double get() const { return m_zero == 0 ? m_worst : std::numeric_limits<double>::infinity(); }

private:
    double m_worst = 0, m_zero = 0;
};

// `s` = -w.
inline double dxWorstKktResidual(const std::vector<double> &x, const std::vector<double> &s, const std::vector<double> &low,
                                 const std::vector<double> &high) {
    dxWorstResidual worst;
    for (std::size_t i = 0; i < x.size(); ++i) worst.add(dxKktResidual(x[i], -s[i], low[i], high[i]), s[i]);
    return worst.get();
}

// --- w of all rows ---------------------------------------------------------------------------------------------

// How v/h is computed: the product with 1/h is faster, and may differ in the last bit.
enum class dxPerStep { Quotient, Product };

// Write u, and inv(M), by tag.
void dxFindBodyMotions(const dxWorldStepProblem &problem, double stepSize, dxBodyVector *motions, dxPerStep perStep = dxPerStep::Quotient);
void dxFindInverseMasses(const dxWorldStepProblem &problem, dxInverseMass *inverseMasses);

// Adds J' x of one joint's rows on one of its bodies. Two numbers at a time, so that sums stay in registers.
template <class Count>
inline void dxAddForces(const dReal *rows, Count count, const double *forces, dxBodyVector &body) {
    typedef double Pair __attribute__((vector_size(2 * sizeof(double))));
    Pair sum[kBodyAxes / 2];
    std::memcpy(sum, body.lane, sizeof sum);
    for (unsigned row = 0; row < count; ++row, rows += kBodyAxes)
        for (unsigned k = 0; k < kBodyAxes / 2; ++k) sum[k] += __builtin_convertvector(dxLoadPair(rows + 2 * k), Pair) * forces[row];
    std::memcpy(body.lane, sum, sizeof sum);
}

// Returns inv(M) force + u.
inline dxBodyVector dxAccelerate(const dxInverseMass &inverse, const dxBodyVector &force, const dxBodyVector &motion) {
    dxBodyVector acceleration = {};
    for (unsigned k = 0; k < 3; ++k) {
        const double *const row = inverse.inertia[k];
        acceleration.lane[k] = force.lane[k] * inverse.mass + motion.lane[k];
        acceleration.lane[3 + k] = row[0] * force.lane[3] + row[1] * force.lane[4] + row[2] * force.lane[5] + motion.lane[3 + k];
    }
    return acceleration;
}

// Writes w by row. `forces` (x) by row; `inverseMasses` and `motions` (u) by tag; c/h and cfm/h are those of the problem. `bodies`: room for
// one vector for each body.
void dxFindRowResidual(const dxWorldStepProblem &problem, const dxInverseMass *inverseMasses, const dxBodyVector *motions, const double *forces,
                       dxBodyVector *bodies, double *w);

// --- what is good enough ------------------------------------------------------------------------------------------

// The residual that is good enough, as part of the largest b and of the largest sum.
struct dxResidualBound {
    double ofB, ofSum;
};

// After an elimination.
constexpr dxResidualBound kEliminationBound = {1e-12, 8 * std::numeric_limits<double>::epsilon()};

// Returns whether the residual is within the bound, given the largest b and sum of the rows. Bodies that fall together have a b that is a
// small difference of large numbers, c/h and J u: where the sum alone does not explain the residual, the largest |J| |u| is added to it.
bool dxIsGoodResidual(const dxResidualBound &bound, double residual, double b, double sum, const dxWorldStepProblem &problem,
                      const dxBodyVector *motions);

// Returns whether forces do what the rows ask for, to a part of the largest b. Hard rows may not have the excuse of large sums: where they repeat
// or contradict one another, forces of 1e16 b cancel out to rounding errors as large as b. Rows with a c do have forces of up to b/c;
// `softSum` is the largest sum of theirs (dxBodySpaceProblem::isSoft).
bool dxIsAnswer(double residual, double b, double softSum, const dxWorldStepProblem &problem, const dxBodyVector *motions);
