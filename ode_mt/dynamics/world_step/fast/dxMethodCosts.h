// Which method is to solve an island, by how long each of them would take: sums of the elements and products that it has to compute, known from
// statistics of the problem, times their measured costs (docs/fast.md, "Three methods"). Units: microseconds of the machine that they
// were measured on; only their ratios count.
//
// Not known beforehand: fill where joints form rings, which Dantzig's algorithm has as well; how many rows change sides; how many
// factorisations an interior point takes. These are those of the median of many scenes.
#pragma once

class dxWorldProcessMemArena;
struct dxWorldStepProblem;

// Below this many rows Dantzig's algorithm may solve an island alone. From there on it is slower than the other methods (docs/fast.md), and
// there is no memory for its matrix.
constexpr unsigned kDantzigThreshold = 700;

// What tells how long each method takes: numbers of bodies, joints and rows, which rows are bilateral, and which joints share bodies. Found
// in one pass over the joints, in less time than they take to write their rows.
//
// Deterministic: addresses do not count.
struct dxLcpStatistics {
    unsigned bodies = 0, joints = 0, rows = 0;

    // --- Dantzig's algorithm ------------------------------------------------------------------------------
    unsigned unilateralRows = 0;
    unsigned bilateralRows() const { return rows - unilateralRows; }

    // Of the factor of the bilateral rows, from its skyline on: elements, and squares of the lengths of its rows.
    double skyline = 0, skylineSquares = 0;

    // --- elimination: a joint's first rows, if these are bilateral -----------------------------------------
    unsigned eliminatedJoints = 0, eliminatedRows = 0;

    // Blocks of two such joints on the same body, and products of two of a body's blocks. There are no others where bodies and joints form
    // a tree; elsewhere there is fill.
    double blocks = 0, products = 0;

    // Requires rows, read. What is taken of the arena is given back.
    static dxLcpStatistics of(const dxWorldStepProblem &problem, dxWorldProcessMemArena &arena);
};

// The part of an island's unilateral rows that are not satisfied without any force, as far as that is known before the problem is solved: all
// but those that push only, or pull only, and need not, and friction beside them. (Bodies that part, or fall together.) What is taken of the
// arena is given back.
double dxFindActiveShare(const dxWorldStepProblem &problem, double stepSize, dxWorldProcessMemArena &arena);

enum class dxWorldStepMethod { Dantzig, Elimination, BodySpace };

struct dxMethodCosts {
    double dantzig, elimination, bodySpace;  // infinity: not possible

    // `activeShare`: the part of the unilateral rows that Dantzig's algorithm has to drive to zero.
    static dxMethodCosts of(const dxLcpStatistics &statistics, double activeShare = 1);

    // Another method than Dantzig's algorithm, that of "exact", has to be faster by more than estimates err.
    dxWorldStepMethod cheapest() const;
};
