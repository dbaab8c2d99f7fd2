// The serial strategy: the islands one after the other on the calling thread, in upstream's order.
//
// QuickStep draws random numbers. While a single thread steps with them, they are drawn one by one, as upstream does
// (dxSingleStepper). Otherwise the step takes those of all islands before the first callback of the user as one block, so that no step of
// another thread draws in between (contract C7).
//
// Threading: one thread, which may be a worker (dxStepWorlds).
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxSerialStep {
public:
    explicit dxSerialStep(const dxStepCall &call) : m_call(call) {}

    // The island workers step islands of at least minLargeJoints joints.
    dxSerialStep(const dxStepCall &call, dxLargeIslandWorkers *islandWorkers, unsigned minLargeJoints)
        : m_call(call), m_islandWorkers(islandWorkers), m_minLargeJoints(minLargeJoints) {}

    // On a worker, which dxBodyWorkers notes.
    dxSerialStep(const dxStepCall &call, unsigned worker) : m_call(call), m_worker(worker) {}

    void run() const;

    // Steps the next `count` islands of the cursor. Their random numbers come from the current scope.
    void stepIslands(dxIslandCursor &cursor, unsigned count) const;

private:
    void runReserving() const;

    const dxStepCall &m_call;
    dxLargeIslandWorkers *const m_islandWorkers = nullptr;
    const unsigned m_minLargeJoints = 0;
    const unsigned m_worker = 0;
};
