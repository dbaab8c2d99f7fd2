// Functions of ode/ode_MT.h that choose threads, algorithm, heuristics and thread manager, and read the counters.
#include <ode/error.h>
#include <ode/ode_MT.h>
#include <ode/version.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

#include "config.h"
#include "error.h"

#include "dynamics/step/islands/dxBodyWorkers.h"
#include "remote/dxRemote.h"
#include "settings/dxProcessStatistics.h"
#include "settings/dxSerialReason.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkers.h"
#include "settings/dxWorldState.h"
#include "settings/dxWorldStatistics.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// The getters return members of dODE_MT_Statistics. Their numbers wrap, so that the difference of two readings is right whatever was counted before.
unsigned lowBits(unsigned long long dODE_MT_Statistics::*count) { return static_cast<unsigned>(dxProcessStatistics::instance().read().*count); }

// Returns what note() returns, or false where it has no memory. That is reported outside the catch clause, as the handler may leave.
template <class Note>
bool noteSolver(const Note &note) {
    try {
        return note();
    } catch (const std::bad_alloc &) {
    }
    dMessage(0, "ODE_MT: no memory to note the solver of a world");
    return false;
}

// Structures begin with their size: a program that was compiled with an older header has a smaller one, one with a newer header a larger one.
// Returns whether it has room for what has to be there.
bool hasRoom(const char *function, std::size_t size, std::size_t least) {
    if (size >= least) return true;
    dMessage(0, "ODE_MT: %s was given a size of %lu bytes, which is too small", function, static_cast<unsigned long>(size));
    return false;
}

// As much as the caller has room for.
template <class Statistics>
void copyKnown(Statistics from, Statistics &to) {
    from.size = std::min(to.size, sizeof to);
    std::memcpy(&to, &from, from.size);
}

// Returns whether there is no error.
int reportTrace(int error, const char *path) {
    if (error > 0) dMessage(0, "ODE_MT: the trace '%.800s' cannot be written: %s", path, std::strerror(error));
    return error == 0;
}

// The same for write(), which writes the file of the trace.
template <class Write>
int writeTrace(const Write &write) {
    char path[800];
    dxTimeline::copyPath(path, sizeof path);
    return reportTrace(write(), path);
}

}  // namespace

extern "C" {

const char *dODE_MT_GetVersion() { return dODE_MT_VERSION; }

const char *dODE_MT_GetUpstreamVersion() { return dODE_VERSION; }

void dToggleODE_MT(int numThreads) {
    dxSettings &settings = dxSettings::instance();
    const unsigned threads = settings.resolveThreads(numThreads);
    if (threads != settings.threads() && !dxWorkers::instance().mayEndWorkers()) return;
    settings.setThreads(threads);
    dxWorkers::instance().resize();
}

int dODE_MT_GetThreads() { return static_cast<int>(dxSettings::instance().threads()); }

int dODE_MT_SetAlgorithm(const char *name) {
    return dxSettings::instance().setAlgorithm(name ? name : "(null)");
}

const char *dODE_MT_GetAlgorithm() { return dxSettings::instance().algorithmName(); }

int dODE_MT_SetSolver(dWorldID world, const char *name) {
    dUASSERT(world, "bad world argument");
    return noteSolver([=] { return dxSetSolver(world, name ? name : "(null)"); });
}

const char *dODE_MT_GetSolver(dWorldID world) {
    dUASSERT(world, "bad world argument");
    return dxSettings::nameOfSolver(dxWorldSettings::of(world).solver.solver);
}

int dODE_MT_SetSolverTolerance(dWorldID world, double tolerance) {
    dUASSERT(world, "bad world argument");
    if (dxSolverChoice::isTolerance(tolerance))
        return noteSolver([=] {
            dxWorldState::of(world).setTolerance(tolerance);
            return true;
        });
    dMessage(0, "ODE_MT: no solver tolerance %.17g; known: a number from 0 to 1", tolerance);
    return 0;
}

double dODE_MT_GetSolverTolerance(dWorldID world) {
    dUASSERT(world, "bad world argument");
    return dxWorldSettings::of(world).solver.tolerance;
}

void dODE_MT_SetWarmStart(dWorldID world, int isWarm) {
    dUASSERT(world, "bad world argument");
    noteSolver([=] {
        dxWorldState::of(world).setWarmStart(isWarm != 0);
        return true;
    });
}

int dODE_MT_GetWarmStart(dWorldID world) {
    dUASSERT(world, "bad world argument");
    return dxWorldSettings::of(world).solver.isWarm ? 1 : 0;
}

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

unsigned dODE_MT_GetParallelSteps() { return lowBits(&dODE_MT_Statistics::parallelSteps); }

unsigned dODE_MT_GetParallelIslands() { return lowBits(&dODE_MT_Statistics::parallelIslands); }

unsigned dODE_MT_GetTeamSteps() { return lowBits(&dODE_MT_Statistics::teamSteps); }

unsigned dODE_MT_GetParallelCollisions() { return lowBits(&dODE_MT_Statistics::parallelCollisions); }

unsigned dODE_MT_GetSharedCollisions() { return lowBits(&dODE_MT_Statistics::sharedCollisions); }

unsigned dODE_MT_GetContactsAhead() { return lowBits(&dODE_MT_Statistics::contactsAhead); }

unsigned dODE_MT_GetContactsAheadUnused() { return lowBits(&dODE_MT_Statistics::contactsAheadUnused); }

unsigned dODE_MT_GetDirectIslands() { return static_cast<unsigned>(dxProcessStatistics::instance().directIslands); }

unsigned dODE_MT_GetDirectFallbacks() { return static_cast<unsigned>(dxProcessStatistics::instance().directFallbacks); }

void dODE_MT_GetStatistics(dODE_MT_Statistics *statistics) {
    if (statistics == nullptr) {
        dMessage(0, "ODE_MT: dODE_MT_GetStatistics was given no place for them (NULL)");
        return;
    }
    *statistics = dxProcessStatistics::instance().read();
}

const char *dODE_MT_GetReasonText(int reason) { return dxTextOfReason(reason); }

int dODE_MT_GetWorldStatistics(dWorldID world, dODE_MT_WorldStatistics *statistics) {
    dUASSERT(world, "bad world argument");
    dUASSERT(statistics, "bad statistics argument");
    if (!hasRoom("dODE_MT_GetWorldStatistics", statistics->size, offsetof(dODE_MT_WorldStatistics, threads))) return 0;
    dxTimeline::startCounting();
    dODE_MT_WorldStatistics last{};
    const bool isKnown = dxWorldStatistics::read(world, last);
    copyKnown(last, *statistics);
    return isKnown;
}

int dODE_MT_GetRemoteStatistics(dODE_MT_RemoteStatistics *statistics) {
    dUASSERT(statistics, "bad statistics argument");
    if (!hasRoom("dODE_MT_GetRemoteStatistics", statistics->size, offsetof(dODE_MT_RemoteStatistics, workersLate))) return 0;
    copyKnown(dxRemote::statistics(), *statistics);
    return 1;
}

int dODE_MT_StartTrace(const char *path) {
    if (path == nullptr || *path == '\0') {
        dMessage(0, "ODE_MT: dODE_MT_StartTrace was given no file (%s)", path == nullptr ? "NULL" : "an empty name");
        return 0;
    }
    return reportTrace(dxTimeline::start(path), path);
}

int dODE_MT_FlushTrace() { return writeTrace(dxTimeline::flush); }

void dODE_MT_RequestTraceFlush() { dxTimeline::requestFlush(); }

int dODE_MT_StopTrace() { return writeTrace(dxTimeline::stop); }

unsigned dODE_MT_GetMaxWorkersUsed() { return dxProcessStatistics::instance().maxWorkersUsed; }

void dODE_MT_NoteBodyWorkers(int isNoted) { dxBodyWorkers::setNoted(isNoted != 0); }

int dODE_MT_GetBodyWorker(dBodyID body) {
    dUASSERT(body, "bad body argument");
    return dxBodyWorkers::of(*body);
}

}  // extern "C"
