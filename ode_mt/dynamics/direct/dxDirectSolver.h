// Solves an island's problem in body space: the two convex problems that upstream's algorithm solves in sequence (docs/direct-solver.md).
//
//   1. all rows without a normal; friction rows have no force
//   2. all rows; a friction row's limits are +- |hi x(normal)|, with the normal's force of the first problem
//
// Threading: one island, one thread, or the workers of a large island, which share its phases. Memory is kept from island to island; the
// process keeps as many solvers as islands are solved at the same time.
#pragma once

#include "dynamics/direct/dxDirectRows.h"
#include "dynamics/direct/dxInteriorPoint.h"
#include "threading/pool/dxPhaseRunner.h"

class dxDirectSolver {
public:
    // Returns whether x was found to a residual that is as good as rounding allows, or nearly. Requires rows as dxDirectRows does.
    bool solve(const dxExactProblem &rows, double stepSize, dxTaskRunner &runner);

    // Of the last call of solve; infinity: none was found.
    double residual() const { return m_residual; }

    // Of its numbers.
    dxInteriorPoint::Scale scale() const { return m_interior.scaleOf(m_interior.x()); }

    // Of any forces, in the places of x, under the limits that the last call of solve found.
    double residualOf(const dxExactProblem &rows);

    // Of the last call of solve that found a residual.
    void writeForces(const dxExactProblem &rows) const { m_rows.writeForces(m_interior.x(), rows); }

private:
    void solveBoth();
    void limitRows();
    bool limitFriction();

    dxPhaseRunner m_phases;
    dxDirectRows m_rows;
    dxInteriorPoint m_interior;
    double m_residual = 0;
};
