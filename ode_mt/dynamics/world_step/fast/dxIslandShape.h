// What an island's problem looks like, as far as it tells how long each method takes (dxMethodCosts.h): numbers of bodies, joints and
// rows, which rows have limits, and which joints share bodies. Found in one pass over the joints, in less time than they take to write their
// rows.
//
// Deterministic: addresses do not count.
#pragma once

class dxWorldProcessMemArena;
struct dxWorldStepProblem;

struct dxIslandShape {
    unsigned bodies = 0, joints = 0, rows = 0;

    // --- Dantzig's algorithm ------------------------------------------------------------------------------
    unsigned limited = 0;  // rows with limits
    unsigned unlimited() const { return rows - limited; }

    // Of the factor of the rows without limits, from its skyline on: elements, and squares of the lengths of its rows.
    double skyline = 0, skylineSquares = 0;

    // --- elimination: a joint's first rows, if these have no limits ----------------------------------------
    unsigned eliminatedJoints = 0, eliminatedRows = 0;

    // Blocks of two such joints on the same body, and products of two of a body's blocks. There are no others where bodies and joints form
    // a tree; elsewhere there is fill.
    double blocks = 0, products = 0;

    // Requires rows, read. What is taken of the arena is given back.
    static dxIslandShape of(const dxWorldStepProblem &problem, dxWorldProcessMemArena &arena);
};

// The part of an island's rows with limits that are not satisfied without any force, as far as that is known before the problem is solved: all
// but those that push only, or pull only, and need not, and friction beside them. (Bodies that part, or fall together.)
double dxFindActiveShare(const dxWorldStepProblem &problem, double stepSize);
