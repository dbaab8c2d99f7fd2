#include "remote/dxRemote.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/dxLog.h"
#include "remote/coordinator/dxRemoteWorkers.h"
#include "remote/islands/dxPackedSolver.h"
#include "remote/islands/dxRemoteIslands.h"
#include "remote/transport/dxRemoteLoader.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkers.h"
#include "threading/process/dxProcessThreads.h"

void dxRemote::open() try {
    const dxRemoteChoice choice = dxSettings::instance().remoteWorkers();
    if (choice.transport == nullptr) return;
    static std::atomic<bool> isOpened{false};
    if (isOpened.exchange(true)) return;
    dxRemoteSolvers::install(dxRemoteIslandSolvers());
    dxRemoteWorkers &workers = dxRemoteWorkers::instance();
    workers.endProcessWhen([] { return dxAreLastThreads({dxRemoteWorkers::kThreadName, dxWorkers::instance().threadName() + "-"}); });
    workers.open(choice.transport, dxDescribeSolver(), [choice](std::string &reason) {
        return dxLoadRemoteTransport(choice.transport, choice.wanted, reason);
    });
    std::atexit(dxRemote::close);  // before the handlers of what was loaded for it
} catch (const std::bad_alloc &) {
    dxLog(dxLogLevel::Warning, "remote workers: no memory; islands stay in this process");
}

void dxRemote::close() { dxRemoteWorkers::instance().close(); }

dODE_MT_RemoteStatistics dxRemote::statistics() {
    const dxRemoteWorkers::Counts counts = dxRemoteWorkers::instance().counts();
    dODE_MT_RemoteStatistics now{};
    now.workers = counts.open;
    now.workersLate = counts.openLate;
    now.workersRefused = counts.refused;
    now.workersLost = counts.lost;
    now.workersReplaced = counts.replaced;
    now.timesLate = counts.late;
    now.islandsSent = counts.sent;
    now.islandsSolved = counts.outcomes[dxRemoteOutcome::Solved];
    now.islandsSooner = counts.outcomes[dxRemoteOutcome::Sooner];
    now.islandsLate = counts.outcomes[dxRemoteOutcome::Late];
    now.islandsLost = counts.outcomes[dxRemoteOutcome::Lost];
    now.islandsGivenBack = counts.outcomes[dxRemoteOutcome::NoResult];
    return now;
}
