// The calls of ode/ode_MT.h that choose threads, algorithm, heuristics and thread manager, and read the counters.
#include <ode/ode_MT.h>

#include "frame/dxSettings.h"
#include "frame/dxStepStatistics.h"
#include "frame/dxWorkers.h"

extern "C" {

void dToggleODE_MT(int numThreads) {
    dxSettings::instance().setThreads(numThreads);
    dxWorkers::instance().resize();
}

int dODE_MT_GetThreads() { return static_cast<int>(dxSettings::instance().threads()); }

int dODE_MT_SetAlgorithm(const char *name) {
    return dxSettings::instance().setAlgorithm(name ? name : "(null)");
}

const char *dODE_MT_GetAlgorithm() { return dxSettings::instance().algorithmName(); }

int dODE_MT_SetCallbackPolicy(const char *name) {
    return dxSettings::instance().setCallbackPolicy(name ? name : "(null)");
}

const char *dODE_MT_GetCallbackPolicy() { return dxSettings::instance().callbackPolicyName(); }

int dODE_MT_SetHeuristics(const char *names) {
    return dxSettings::instance().setHeuristics(names ? names : "(null)");
}

const char *dODE_MT_GetHeuristics() { return dxNamesOfHeuristics(dxSettings::instance().heuristics()); }

int dODE_MT_SetGridCells(int cells) { return dxSettings::instance().setGridCells(cells); }

int dODE_MT_GetGridCells() { return dxSettings::instance().gridCells(); }

int dODE_MT_SetThreadManager(const char *name) { return dxWorkers::instance().choose(name ? name : "(null)"); }

const char *dODE_MT_GetThreadManager() { return dxWorkers::instance().name(); }

unsigned dODE_MT_GetParallelSteps() { return dxStepStatistics::instance().parallelSteps; }

unsigned dODE_MT_GetParallelIslands() { return dxStepStatistics::instance().parallelIslands; }

unsigned dODE_MT_GetTeamSteps() { return dxStepStatistics::instance().teamSteps; }

unsigned dODE_MT_GetParallelCollisions() { return dxStepStatistics::instance().parallelCollisions; }

unsigned dODE_MT_GetSharedCollisions() { return dxStepStatistics::instance().sharedCollisions; }

unsigned dODE_MT_GetContactsAhead() { return dxStepStatistics::instance().contactsAhead; }

unsigned dODE_MT_GetContactsAheadUnused() { return dxStepStatistics::instance().contactsAheadUnused; }

unsigned dODE_MT_GetMaxWorkersUsed() { return dxStepStatistics::instance().maxWorkersUsed; }

}  // extern "C"
