#include "remote/islands/dxRemoteIslands.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/dxStopwatch.h"
#include "dynamics/step/dxCostModel.h"
#include "dynamics/step/islands/dxBodyWorkers.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/world_step/dxWorldStep.h"
#include "dynamics/world_step/dxWorldStepBodies.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "remote/islands/dxPackedProblem.h"
#include "remote/islands/dxRemoteShare.h"
#include "settings/dxJointAttachment.h"
#include "settings/dxSettings.h"
#include "threading/dxFloatEnvironment.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// Upper bounds of what dxMakeWorldStepProblem takes from its arena.
std::size_t memoryFor(const dxIsland &island) {
    constexpr std::size_t kSlack = 1024, kRowBytes = sizeof(dReal) * (dxWorldStepProblem::kSides * dxWorldStepProblem::kElements + 4) + sizeof(int);
    return island.bodyCount * (sizeof(dxInverseInertia) + sizeof(unsigned)) +
           island.jointCount * (2 * sizeof(dxWorldStepJoint) + dxWorldStepProblem::kSides * sizeof(unsigned) + kMaxJointRows * kRowBytes) + kSlack;
}

class IslandSolvers final : public dxRemoteSolvers {
public:
    bool maySolve(const dxStepCall &call) const override {
        if (!dxRemoteWorkers::instance().areThere() || call.kind != dxStepperKind::WorldExact) return false;
        const dxAlgorithm algorithm = dxSettings::instance().algorithm();
        const unsigned least = algorithm == dxAlgorithm::Auto ? 2 : 1;  // one island alone gains nothing
        return call.count >= least && algorithm != dxAlgorithm::Serial && !dxTrapsFloatingPoint() && !dxJointAttachment::hasAny(*call.world);
    }

    double predictShare(const dxRemoteWork &work, unsigned workers) const override {
        return std::min(kRemoteReserve * dxPredictRemoteShare(work, workers, dxRemoteWorkers::instance().capacity()), 1.0);
    }

    std::unique_ptr<dxRemoteStep> begin(dxDeferredIslands &islands, double share, bool isForced) override {
        return std::make_unique<dxRemoteIslands>(islands, share, isForced);
    }

    void wake() override { dxRemoteWorkers::instance().wake(); }

    void noteWorkers(dxRemoteRecord &record) const override {
        const dxRemoteWorkers::Counts counts = dxRemoteWorkers::instance().counts();
        record.workers = counts.open;
        record.lostWorkers = counts.lost;
    }
};

}  // namespace

dxRemoteSolvers &dxRemoteIslandSolvers() {
    static IslandSolvers solvers;
    return solvers;
}

dxRemoteIslands::dxRemoteIslands(dxDeferredIslands &islands, double share, bool isForced)
    : m_islands(islands), m_scale(dxCostModel::instance().cautiousScale(islands.call().kind)) {
    dxStepRecords &records = islands.records();
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
    const dxStepCall &call = m_islands.call();
    return {call.world, call.stepSize, islandOf(entry), arena};
}

double dxRemoteIslands::solverCost(const Entry &entry) const {
    return kRemoteSolverPart * m_scale * m_islands.records().islands[entry.island].cost;
}

// Without memory for the problem the island is stepped like a local one.
void dxRemoteIslands::make(unsigned entry, unsigned worker) {
    Entry &one = m_entries[entry];
    if (!m_islands.isNeeded(one.island)) return m_batch->drop(entry);
    one.arena = dxWorkingMemory::take(memoryFor(islandOf(one)));
    if (one.arena == nullptr) {
        m_batch->drop(entry);
        return m_islands.step(one.island, worker);
    }
    if (!m_islands.save(one.island, worker)) return m_batch->drop(entry);
    m_islands.run(one.island, worker, [this, entry] { makeProblem(entry); });
}

// Without memory for the bytes this process solves the problem.
void dxRemoteIslands::makeProblem(unsigned entry) {
    Entry &one = m_entries[entry];
    try {
        dxMakeWorldStepProblem(stepOf(one, one.arena), one.problem);
    } catch (...) {
        m_batch->drop(entry);
        throw;
    }
    if (dxTimelineRing *const ring = dxTimeline::ofThisThread()) ring->countRows(one.problem.rowCount);  // for this process or a worker
    if (one.problem.rowCount == 0) return m_batch->keep(entry);
    dxRemoteBytes bytes = m_batch->takeSpare();
    try {
        dxPackProblem(one.problem, m_islands.call().stepSize, bytes);
    } catch (const std::bad_alloc &) {
        return m_batch->keep(entry);
    }
    m_batch->submit(entry, std::move(bytes), solverCost(one));
}

void dxRemoteIslands::finish(unsigned worker) {
    unsigned entry = 0;
    bool hasResult = false;
    for (dxRemoteBytes result; next(entry, result, hasResult);) {
        if (hasResult || m_islands.arenaOf(worker) != nullptr)
            finishEntry(m_entries[entry], worker, result, hasResult);
        else
            m_entries[entry].isPostponed = true;
        poll();
    }
}

dxRemoteRecord dxRemoteIslands::finishRest() {
    for (Entry &entry : m_entries)
        if (entry.isPostponed) finishEntry(entry, 0, {}, false);
    const dxRemoteOutcomes outcomes = m_batch->outcomes();
    dxRemoteRecord record;
    record.solved = static_cast<unsigned>(outcomes.solved());
    record.returned = static_cast<unsigned>(outcomes.returned());
    return record;
}

// Waits for an entry that can be finished; false: there is none left.
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

void dxRemoteIslands::finishEntry(Entry &entry, unsigned worker, const dxRemoteBytes &result, bool hasResult) {
    if (!m_islands.isNeeded(entry.island)) return;
    m_islands.run(entry.island, worker, [&] {
        apply(entry, result, hasResult, m_islands.records().workers[worker].arena);
        dxBodyWorkers::note(islandOf(entry), worker);
    });
}

// Solves it in the arena if there is no result. Reports messages, and so may throw dxUpstreamInterrupted.
void dxRemoteIslands::apply(Entry &entry, const dxRemoteBytes &result, bool hasResult, dxWorldProcessMemArena *arena) {
    if (arena != nullptr) arena->ResetState();
    const dxIslandStep step = stepOf(entry, arena);
    if (hasResult)
        dxReportPackedMessages(result);
    else if (entry.problem.rowCount > 0)
        solve(step, entry);
    dxApplyResults(step, entry.problem);
    dxWorkingMemory::giveBack(entry.arena);
    entry.arena = nullptr;
}

void dxRemoteIslands::solve(const dxIslandStep &step, Entry &entry) {
    const dxStopwatch stopwatch;
    dxDantzigSolver().solve(step, entry.problem);
    m_batch->noteLocal(solverCost(entry), stopwatch.ns());
}
