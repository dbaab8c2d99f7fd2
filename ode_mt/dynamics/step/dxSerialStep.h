// The serial strategy: the islands one after the other on the calling thread, in upstream's order.
//
// QuickStep draws random numbers. While one thread alone steps with them they are drawn one by one, as upstream does
// (dxSingleStepper); else those of all islands before the first callback of the user are taken as one block, so that no step of
// another thread draws in between (contract C7).
#pragma once

#include "dynamics/step/dxStepCall.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxSerialStep {
public:
    explicit dxSerialStep(const dxStepCall &call) : m_call(call) {}

    // Islands of at least so many joints are stepped by the islandWorkers.
    dxSerialStep(const dxStepCall &call, dxLargeIslandWorkers *islandWorkers, unsigned minLargeJoints)
        : m_call(call), m_islandWorkers(islandWorkers), m_minLargeJoints(minLargeJoints) {}

    // On a worker, which is noted as the one that has stepped the bodies.
    dxSerialStep(const dxStepCall &call, unsigned worker) : m_call(call), m_worker(worker) {}

    void run() const;

    // Some islands in a row, whose random numbers are drawn from the scope in force.
    void stepIslands(dxIslandCursor cursor, unsigned count) const;

private:
    void runReserving() const;

    const dxStepCall &m_call;
    dxLargeIslandWorkers *const m_islandWorkers = nullptr;
    const unsigned m_minLargeJoints = 0;
    const unsigned m_worker = 0;
};
