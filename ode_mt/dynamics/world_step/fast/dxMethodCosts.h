// Which method is to solve an island, by how long each of them would take: sums of the elements and products that it has to compute, known from
// the problem's shape, times their measured costs (docs/direct-solver.md, "Which method"). Microseconds of the machine that they
// were measured on; only their ratios count.
//
// Not known beforehand: fill where joints form rings, which Dantzig's algorithm has as well; how many rows change sides; how many
// factorisations an interior point takes. These are those of the median of many scenes.
#pragma once

struct dxIslandShape;

enum class dxDirectMethod { Dantzig, Elimination, BodySpace };

struct dxMethodCosts {
    double dantzig, elimination, bodySpace;  // infinity: not possible

    // `activeShare`: the part of the rows with limits that Dantzig's algorithm has to drive to zero.
    static dxMethodCosts of(const dxIslandShape &shape, double activeShare = 1);

    // Another method than Dantzig's algorithm, that of "exact", has to be faster by more than estimates err.
    dxDirectMethod cheapest() const;
};
