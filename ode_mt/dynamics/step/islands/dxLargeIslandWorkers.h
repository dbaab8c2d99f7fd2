// Workers that step one large island together, and their state from step to step: memory and measurements.
#pragma once

#include "threading/payoff/dxSharingPolicy.h"
#include "threading/dxTaskRunner.h"
#include "threading/process/dxObjectPool.h"

struct dxLargeIslandWorkers {
    dxTaskRunner *runner = nullptr;
    bool isAlwaysParallel = false;  // parallel whenever the island is large enough; otherwise the measured times decide
    dxSharingPolicy solvePolicy;  // of the exact step's triangular solves
};

// Borrows the workers' state for a step; its memory is returned to the process's pool.
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
