#include "dynamics/step/islands/dxIslandStep.h"

#include "threading/process/dxProcess.h"

namespace {

dxProcessObject<dxObjectPool<dxLargeIslandWorkers>> pool;

}  // namespace

dxLargeIslandWorkersLease::dxLargeIslandWorkersLease(dxTaskRunner &runner, bool isAlwaysParallel) : m_islandWorkers(*pool) {
    m_islandWorkers->runner = &runner;
    m_islandWorkers->isAlwaysParallel = isAlwaysParallel;
}

dxLargeIslandWorkersLease::~dxLargeIslandWorkersLease() { m_islandWorkers->runner = nullptr; }
