#include "dynamics/step/dxLargeIslandStep.h"

#include <algorithm>
#include <new>
#include <optional>

#include "dynamics/step/dxSerialStep.h"
#include "settings/dxProcessStatistics.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkersRunner.h"
#include "threading/process/dxProcess.h"

namespace {

// Workers of one island wait for one another, so more of them than cores would only delay one another. An
// algorithm that the user has named gets this number on any machine, so that tests can run it there.
constexpr unsigned kMinWorkers = 4;

dxProcessObject<dxObjectPool<dxLargeIslandWorkers>> pool;

}  // namespace

void dxRunLargeIslandStep(const dxStepCall &call, const dxStepPlan &plan) {
    const unsigned most = std::max(dxSettings::instance().cores(), kMinWorkers);
    dxWorkersRunner runner(std::min(plan.workers, most), call.world);
    std::optional<dxLargeIslandWorkersLease> lease;
    dxLargeIslandWorkers *islandWorkers = nullptr;
    try {
        islandWorkers = &*lease.emplace(runner, dxSettings::instance().algorithm() != dxAlgorithm::Auto);
    } catch (const std::bad_alloc &) {  // the calling thread steps large islands, too
    }
    dxSerialStep(call, islandWorkers, plan.minLargeJoints).run();
    dxProcessStatistics::instance().countLargeIslandStep(runner.tookPart());
}

dxLargeIslandWorkersLease::dxLargeIslandWorkersLease(dxTaskRunner &runner, bool isAlwaysParallel) : m_islandWorkers(*pool) {
    m_islandWorkers->runner = &runner;
    m_islandWorkers->isAlwaysParallel = isAlwaysParallel;
}

dxLargeIslandWorkersLease::~dxLargeIslandWorkersLease() { m_islandWorkers->runner = nullptr; }
