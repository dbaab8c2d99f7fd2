#include "dynamics/step/dxLargeIslandStep.h"

#include <algorithm>
#include <new>
#include <optional>

#include "dynamics/step/dxSerialStep.h"
#include "dynamics/step/islands/dxIslandStep.h"
#include "settings/dxSettings.h"
#include "settings/dxStepStatistics.h"
#include "settings/dxWorkersRunner.h"

namespace {

// Workers of one island wait for one another, so more of them than cores would only get in one another's way. An
// algorithm that is asked for by name gets so many on any machine: what they do can be tested there.
constexpr unsigned kMinWorkers = 4;

}  // namespace

void dxRunLargeIslandStep(const dxStepCall &call, const dxStepPlan &plan) {
    const unsigned most = std::max(dxSettings::instance().cores(), kMinWorkers);
    dxWorkersRunner runner(std::min(plan.workers, most), call.world);
    std::optional<dxLargeIslandWorkersLease> lease;
    dxLargeIslandWorkers *islandWorkers = nullptr;
    try {
        islandWorkers = &*lease.emplace(runner, dxSettings::instance().algorithm() != dxAlgorithm::Auto);
    } catch (const std::bad_alloc &) {  // then without one
    }
    dxSerialStep(call, islandWorkers, plan.minLargeJoints).run();
    dxStepStatistics::instance().countLargeIslandStep(runner.tookPart());
}
