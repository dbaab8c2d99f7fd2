#include "dynamics/step/dxRemoteIslands.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "settings/dxJointAttachment.h"
#include "core/dxLog.h"
#include "core/dxStopwatch.h"
#include "dynamics/remote/dxPackedProblem.h"
#include "dynamics/remote/dxPackedSolver.h"
#include "dynamics/remote/dxRemoteShare.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/dxWorldStep.h"
#include "dynamics/world_step/dxWorldStepResults.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "remote/dxRemoteLoader.h"
#include "settings/dxSettings.h"
#include "settings/dxWorkers.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/pool/dxLastThreads.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// Upper bounds of what dxMakeWorldStepProblem takes from its arena.
std::size_t memoryFor(const dxIsland &island) {
    constexpr std::size_t kSlack = 1024, kRowBytes = sizeof(dReal) * (dxWorldStepProblem::kSides * dxWorldStepProblem::kElements + 4) + sizeof(int);
    return island.bodyCount * (sizeof(dxInverseInertia) + sizeof(unsigned)) +
           island.jointCount * (2 * sizeof(dxWorldStepJoint) + dxWorldStepProblem::kSides * sizeof(unsigned) + kMaxJointRows * kRowBytes) + kSlack;
}

void closeAtExit() { dxRemoteIslands::close(); }

}  // namespace

void dxRemoteIslands::open() try {
    const dxRemoteChoice choice = dxSettings::instance().remoteWorkers();
    if (choice.transport == nullptr) return;
    static std::atomic<bool> isOpened{false};
    if (isOpened.exchange(true)) return;
    dxRemoteWorkers::instance().endProcessWhen([] { return dxAreLastThreads({dxRemoteWorkers::kThreadName, dxWorkers::instance().threadName() + "-"}); });
    dxRemoteWorkers::instance().open(choice.transport, dxDescribeSolver(), [choice](std::string &reason) {
        return dxLoadRemoteTransport(choice.transport, choice.wanted, reason);
    });
    std::atexit(closeAtExit);  // before the handlers of what was loaded for it
} catch (const std::bad_alloc &) {
    dxLog(dxLogLevel::warning, "remote workers: no memory; islands stay at home");
}

void dxRemoteIslands::close() { dxRemoteWorkers::instance().close(); }

bool dxRemoteIslands::mayHelp(const dxStepCall &call) {
    if (!dxRemoteWorkers::instance().areThere() || call.kind != dxStepperKind::WorldExact) return false;
    const dxAlgorithm algorithm = dxSettings::instance().algorithm();
    const unsigned least = algorithm == dxAlgorithm::Auto ? 2 : 1;  // one island alone gains nothing
    return call.count >= least && algorithm != dxAlgorithm::Serial && !dxTrapsFloatingPoint() && !dxJointAttachment::hasAny(*call.world);
}

dODE_MT_RemoteStatistics dxRemoteIslands::statistics() {
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

dxRemoteRecord dxRemoteIslands::recordOf(const dxRemoteOutcomes &outcomes) {
    const dxRemoteWorkers::Counts counts = dxRemoteWorkers::instance().counts();
    return {counts.open, counts.lost, static_cast<unsigned>(outcomes.solved()), static_cast<unsigned>(outcomes.returned())};
}

dxRemoteIslands::dxRemoteIslands(const dxStepCall &call, dxStepRecords &records, double share, bool isForced)
    : m_call(call), m_records(records), m_scale(dxCostModel::instance().cautiousScale(call.kind)) {
    std::vector<unsigned> order(records.inOrderFrom);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&records](unsigned a, unsigned b) { return records.islands[a].cost > records.islands[b].cost; });
    double left = 0;
    for (const unsigned island : order) left += share * records.islands[island].cost;
    for (const unsigned island : order) {
        if (!isForced && left <= 0) break;
        dxIslandRecord &record = records.islands[island];
        if (record.island.jointCount == 0) continue;
        left -= record.cost;
        record.isRemote = true;
        m_entries.push_back({island, false, nullptr, {}});
    }
    m_batch = std::make_unique<dxRemoteBatch>(dxRemoteWorkers::instance(), count(), !isForced);
}

dxRemoteIslands::~dxRemoteIslands() {
    for (const Entry &entry : m_entries)
        if (entry.arena != nullptr) dxWorkingMemory::giveBack(entry.arena);
}

dxIslandStep dxRemoteIslands::stepOf(const Entry &entry, dxWorldProcessMemArena *arena) const {
    return {m_call.world, m_call.stepSize, m_records.islands[entry.island].island, arena};
}

bool dxRemoteIslands::prepare(unsigned entry) {
    Entry &one = m_entries[entry];
    one.arena = dxWorkingMemory::take(memoryFor(m_records.islands[one.island].island));
    return one.arena != nullptr;
}

// Without memory for the bytes the problem is solved at home.
void dxRemoteIslands::make(unsigned entry) {
    Entry &one = m_entries[entry];
    try {
        dxMakeWorldStepProblem(stepOf(one, one.arena), one.problem);
    } catch (...) {
        m_batch->drop(entry);
        throw;
    }
    if (dxTimelineRing *const ring = dxTimeline::ofThisThread()) ring->countRows(one.problem.rowCount);  // whoever solves them
    if (one.problem.rowCount == 0) return m_batch->keep(entry);
    dxRemoteBytes bytes = m_batch->room();
    try {
        dxPackProblem(one.problem, m_call.stepSize, bytes);
    } catch (const std::bad_alloc &) {
        return m_batch->keep(entry);
    }
    m_batch->submit(entry, std::move(bytes), solverCost(one));
}

double dxRemoteIslands::solverCost(const Entry &entry) const { return kRemoteSolverPart * m_scale * m_records.islands[entry.island].cost; }

void dxRemoteIslands::solve(const dxIslandStep &step, Entry &entry) {
    const dxStopwatch stopwatch;
    dxDantzigSolver().solve(step, entry.problem);
    m_batch->noteHome(solverCost(entry), stopwatch.ns());
}

bool dxRemoteIslands::next(unsigned &entry, dxRemoteBytes &result, bool &hasResult) {
    for (;;) {
        const dxRemoteBatch::Next next = m_batch->next(entry, result);
        if (next == dxRemoteBatch::Next::None) return false;
        hasResult = next == dxRemoteBatch::Next::Result;
        if (!hasResult) return true;
        switch (dxReadPackedResult(result, m_entries[entry].problem)) {
            case dxPackedAnswer::Solved: return true;
            case dxPackedAnswer::GivenBack: m_batch->noteGivenBack(); hasResult = false; return true;
            case dxPackedAnswer::Wrong: m_batch->reject(entry); break;
        }
    }
}

void dxRemoteIslands::finish(unsigned entry, const dxRemoteBytes &result, bool hasResult, dxWorldProcessMemArena *arena) {
    Entry &one = m_entries[entry];
    if (arena != nullptr) arena->ResetState();
    const dxIslandStep step = stepOf(one, arena);
    if (hasResult)
        dxReportPackedMessages(result);
    else if (one.problem.rowCount > 0)
        solve(step, one);
    dxApplyResults(step, one.problem);
    dxWorkingMemory::giveBack(one.arena);
    one.arena = nullptr;
}
