#include "settings/dxWorldSolver.h"

#include "threading/process/dxPerWorld.h"
#include "threading/process/dxProcessObject.h"

namespace dxWorldSolver {

namespace {

dxProcessObject<dxPerWorld<dxSolverChoice>> choices;

// A world's own choice begins as the process's.
template <class Change>
void change(const dxWorld *world, const Change &change) {
    choices->visitOrMake(world, [] { return dxSettings::instance().solver(); }, change);
}

}  // namespace

dxSolverChoice of(const dxWorld *world) {
    dxSolverChoice choice = dxSettings::instance().solver();
    choices->visit(world, [&choice](const dxSolverChoice &own) { choice = own; });
    return choice;
}

bool choose(const dxWorld *world, const std::string &name) {
    dxSolver solver = dxSolver::Exact;
    if (!dxSettings::readSolver(name, solver)) return false;
    if (solver != dxSolver::Exact) dxSettings::instance().allowFast();
    change(world, [solver](dxSolverChoice &own) { own.solver = solver; });
    return true;
}

void setTolerance(const dxWorld *world, double tolerance) {
    change(world, [tolerance](dxSolverChoice &own) { own.tolerance = tolerance; });
}

void setWarmStart(const dxWorld *world, bool isWarm) {
    change(world, [isWarm](dxSolverChoice &own) { own.isWarm = isWarm; });
}

void forget(const dxWorld *world) { choices->forget(world); }

}  // namespace dxWorldSolver
