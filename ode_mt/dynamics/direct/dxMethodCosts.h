// How long each method of dxFastSolver would take for an island, estimated from what its problem looks like: sums of the elements and products that
// each of them has to compute, times their measured costs (docs/direct-solver.md, "Which method"). Microseconds of the machine that they
// were measured on; only their ratios count.
//
// Not known beforehand: fill where joints form rings, which Dantzig's algorithm has as well; how many rows change sides; how many
// factorisations an interior point takes. These are those of the median of many scenes.
#pragma once

#include <limits>

struct dxIslandShape;

struct dxMethodCosts {
    static constexpr double kImpossible = std::numeric_limits<double>::infinity();

    double dantzig, elimination, bodySpace;

    static dxMethodCosts of(const dxIslandShape &shape);
};
