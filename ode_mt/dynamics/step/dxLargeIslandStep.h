// The large-island strategy: the islands in upstream's order, as in the serial one, and each large island by all workers
// together. See docs/step.md.
//
// Threading: the thread that calls the step.
#pragma once

#include "dynamics/step/dxStepStrategy.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "threading/process/dxObjectPool.h"

void dxRunLargeIslandStep(const dxStepCall &call, const dxStepPlan &plan);

// The workers of large islands for a step, with the state that a pool of the process keeps. Throws std::bad_alloc.
class dxLargeIslandWorkersLease {
public:
    dxLargeIslandWorkersLease(dxTaskRunner &runner, bool isAlwaysParallel);
    ~dxLargeIslandWorkersLease();
    dxLargeIslandWorkersLease(const dxLargeIslandWorkersLease &) = delete;
    dxLargeIslandWorkersLease &operator=(const dxLargeIslandWorkersLease &) = delete;

    dxLargeIslandWorkers &operator*() const { return *m_islandWorkers; }

private:
    dxPooledObject<dxLargeIslandWorkers> m_islandWorkers;
};
