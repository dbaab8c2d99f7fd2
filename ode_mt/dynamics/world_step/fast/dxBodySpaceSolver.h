// Solves an island's problem in body space: the two convex problems that upstream's algorithm solves in sequence (docs/fast.md).
//
//   1. all rows without a normal; friction rows have no force
//   2. all rows; a friction row's limits are +- |hi x(normal)|, with the normal's force of the first problem
//
// Where no forces satisfy all rows (hard rows that contradict one another), or those that do are not unique and numbers are lost in them (rows that
// repeat one another), regularise() finds forces of which least is left (docs/fast.md, "Regularised rows").
//
// Threading: one island, one thread, or the workers of a large island, which share its phases. Memory is kept from island to island; the
// process keeps as many solvers as islands are solved at the same time.
#pragma once

#include "dynamics/world_step/fast/dxBodySpaceProblem.h"
#include "dynamics/world_step/fast/dxInteriorPoint.h"
#include "threading/pool/dxPhaseRunner.h"

class dxBodySpaceSolver {
public:
    // Requires rows as dxBodySpaceRows does, and returns what it does. All that follows is about these rows.
    bool read(const dxWorldStepProblem &rows, double stepSize, dxTaskRunner &runner);

    // Returns whether x was found to a residual that is as good as rounding allows, or nearly.
    bool solve(dxTaskRunner &runner);

    // Returns whether x was found that leaves the least energy of the residual, or nearly. Small forces are preferred to large ones.
    bool regularise(dxTaskRunner &runner);

    // Of what was found last; infinity: nothing was.
    double residual() const { return m_residual; }

    // Of its numbers.
    dxInteriorPoint::Scale scale() const { return m_interior.scaleOf(m_interior.x()); }

    // The energy of the residual of regularised rows.
    double energy() const { return m_energy; }

    // Of any forces, in the places of x, under the limits that were found last.
    double residualOf(const dxWorldStepProblem &rows);
    double energyOf(const dxWorldStepProblem &rows);

    // Whether forces of such a residual do what the rows ask for.
    bool isAnswer(double residual) const;

    // What was found last.
    void writeForces(const dxWorldStepProblem &rows) const { m_rows.writeForces(m_interior.x(), rows); }

private:
    void solveBoth();
    void solveRegularised();
    bool solveSoftened(double part, const std::vector<double> &b, const std::vector<double> &c, std::vector<double> &x);
    void soften(double part, const std::vector<double> &b, const std::vector<double> &c, const std::vector<double> &x);
    void limitRows();
    bool limitFriction();

    dxPhaseRunner m_phases;
    dxBodySpaceRows m_rows;
    dxInteriorPoint m_interior;
    const dxWorldStepProblem *m_source = nullptr;
    double m_residual = 0, m_energy = 0;
};
