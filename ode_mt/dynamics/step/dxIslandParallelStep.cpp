#include "dynamics/step/dxIslandParallelStep.h"

#include <algorithm>
#include <new>

#include "core/dxStopwatch.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/step/dxIslandPreparation.h"
#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/dxSerialStep.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/random/dxRandom.h"
#include "dynamics/step/random/dxIslandDraws.h"
#include "settings/dxWorkersRunner.h"

void dxIslandParallelStep::run() {
    const dxStopwatch stopwatch;
    if (!prepare()) {
        m_plan.reason = dODE_MT_REASON_MEMORY;
        m_islands.reset();
        m_records.reset();
        dxSerialStep(m_call).run();
        return;
    }
    unsigned rest;
    {
        const dxWorldArena arena(m_call.world);
        m_records->workers[0].arena = arena.get();
        dxReserveRandomNumbers(m_call, *m_records);
        runBlocks();
        m_islands->stepRest();
        if (m_remote) m_plan.remote = m_remote->finishRest();
        m_remote.reset();
        learn(stopwatch.ns());
        rest = m_islands->commit();
    }
    finishInOrder(rest);
}

// Sets the reason where fewer than two islands come before the first one that has to be stepped in order.
void dxIslandParallelStep::noteOrder() {
    if (m_records->inOrderFrom >= 2 || m_records->inOrderFrom == m_call.count) return;
    const dxIsland &first = m_records->islands[m_records->inOrderFrom].island;
    m_plan.reason = dxHasMovedCallback(first) ? dODE_MT_REASON_MOVED_CALLBACK : dODE_MT_REASON_FEEDBACK;
}

// The world is unchanged. Returns false if there is no memory.
bool dxIslandParallelStep::prepare() try {
    const dxTimelineSpan preparation(dxStepEvents::kIslandPreparation);
    m_records = dxStepRecords::take();
    dxPrepareIslands(m_call, m_plan.workers, *m_records);
    noteOrder();
    m_islands.emplace(m_call, *m_records);
    if (m_plan.remoteShare > 0) m_remote = dxRemoteSolvers::installed()->begin(*m_islands, m_plan.remoteShare, m_plan.isRemoteForced);
    if (m_call.fastQuickStep != nullptr) m_call.fastQuickStep->provideSolvers(m_plan.workers);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

// Blocks begin in their order: first those that make the problems for remote workers, then those of local islands, then those that wait for results
// of remote workers.
void dxIslandParallelStep::runBlocks() {
    const unsigned made = m_remote ? m_remote->count() : 0, stepped = static_cast<unsigned>(m_records->blocks.size());
    const unsigned finished = m_remote ? m_plan.workers : 0;
    dxWorkersRunner(m_plan.workers, m_call.world)
        .forBlocks(dxParallelStage::Islands, made + stepped + finished, [this, made, stepped](unsigned block, unsigned worker) {
            if (block < made) return m_remote->make(block, worker);
            if (block < made + stepped) return stepBlock(block - made, worker);
            m_remote->finish(worker);
        });
}

void dxIslandParallelStep::stepBlock(unsigned block, unsigned worker) {
    const dxStopwatch stopwatch;
    const dxIslandBlock range = m_records->blocks[block];
    double cost = 0;
    for (unsigned i = range.begin; i < range.end; ++i) {
        const unsigned index = m_records->order[i];
        if (m_records->islands[index].isRemote) continue;
        cost += m_records->islands[index].cost;
        m_islands->step(index, worker);
        if (m_remote) m_remote->poll();
    }
    const double ns = stopwatch.ns();
    m_records->run.addBusy(worker, ns);
    if (m_remote) m_remote->noteStepped(cost, ns);
}

void dxIslandParallelStep::finishInOrder(unsigned begin) {
    if (begin == m_call.count) return;
    const unsigned inOrderFrom = m_records->inOrderFrom;
    const bool reserved = dxIslandStepper::drawsRandomNumbers(m_call) && begin < inOrderFrom;
    const std::uint32_t seed = reserved ? m_records->run.seedOf(begin) : 0, end = m_records->run.randomEnd();
    const unsigned reservedCount = inOrderFrom - std::min(begin, inOrderFrom);
    m_islands.reset();
    m_records.reset();  // from here on user code runs, which may leave the step by longjmp

    const dxSerialStep inOrder(m_call);
    dxIslandCursor cursor(m_call.info);
    for (unsigned i = 0; i < begin; ++i) cursor.next();
    if (reserved && !dxRandom::rewindShared(end, seed)) {
        dxReservedDraws draws(seed, end);
        inOrder.stepIslands(cursor, reservedCount);
        begin = inOrderFrom;
    }
    inOrder.stepIslands(cursor, m_call.count - begin);
}

void dxIslandParallelStep::learn(double wallNs) const {
    if (m_records->inOrderFrom != m_call.count || m_records->run.interrupted() != m_call.count) return;
    const double busyNs = m_records->run.busyNs();
    if (m_plan.remoteShare > 0) return learnFromRest(busyNs);
    dxCostModel::instance().learnParallel(m_call.kind, m_plan.costs.total, m_plan.costs.largest, m_plan.workers, busyNs,
                                          wallNs);
}

// Learns from the local islands alone: other processes were busy, too, so the time of the step does not tell the overhead here.
void dxIslandParallelStep::learnFromRest(double busyNs) const {
    double cost = 0;
    for (const dxIslandRecord &record : m_records->islands)
        if (!record.isRemote) cost += record.cost;
    dxCostModel::instance().learnSerial(m_call.kind, cost, busyNs);
}
