// The numbers that the interior-point method has of each row, and its loops over them. All arrays have a multiple of kBodyLanes elements,
// and so have ranges. The bits do not depend on the instruction set: sums are over as many lanes as kBodyLanes, in the order of the rows.
#pragma once

#include <vector>

// The distance to a limit that there is not: nothing compares with it, and 0 times it is 0.
constexpr double kFarLimit = 1e300;

struct dxInteriorRows {
    std::vector<double> low, high;              // limits; equal: fixed
    std::vector<double> b, c, softness;         // dxDirectProblem
    std::vector<double> x;
    std::vector<double> toLow, toHigh;          // distances; kFarLimit where there is no limit
    std::vector<double> pullLow, pullHigh;      // multipliers; 0 where there is no limit
    std::vector<double> dx, dPullLow, dPullHigh;  // of a step
    std::vector<double> s;                      // b - (J inv(M) J' + c) x

    // `padded` elements, of which those from `rows` on are fixed at 0. The others keep their values. Throws std::bad_alloc.
    void resize(unsigned rows, unsigned padded);
};

namespace dxInteriorLoops {

// Of a step, or of a part of its rows.
struct Step {
    double largestLoss = 0;  // of all distances and multipliers, the largest part of one that the step takes
    double energy = 0;       // the sum of changes of distances times changes of multipliers

    // Both parts, in the order in which they are added.
    void add(const Step &other) {
        if (other.largestLoss > largestLoss) largestLoss = other.largestLoss;
        energy += other.energy;
    }
};

// s for J inv(M) J' x = `change`; the weights inv(D) for D = c + zl / l + zh / h, 0 where a row is fixed; s times them.
void prepare(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, double *weight, double *scaled);

// The step to a target of 0, for J du = `change`.
Step predict(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight);

// The right-hand side of the step to `target`, corrected by the products that the predicted one left out, times the weights.
void correct(dxInteriorRows &rows, unsigned begin, unsigned end, double target, const double *weight, double *scaled);

// That step, for J du = `change`.
Step finish(dxInteriorRows &rows, unsigned begin, unsigned end, const double *change, const double *weight);

// Goes a part of the step. Returns the sum of all products of distances and multipliers then.
double advance(dxInteriorRows &rows, unsigned begin, unsigned end, double length);

}  // namespace dxInteriorLoops
