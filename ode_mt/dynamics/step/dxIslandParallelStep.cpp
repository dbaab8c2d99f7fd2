#include "dynamics/step/dxIslandParallelStep.h"

#include <algorithm>
#include <new>

#include "core/dxAtomicLeast.h"
#include "core/dxStopwatch.h"
#include "dynamics/quick_step/fast/dxIterativeWorld.h"
#include "dynamics/step/dxIslandPreparation.h"
#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/dxSerialStep.h"
#include "dynamics/step/dxWorldArena.h"
#include "dynamics/step/islands/dxBodyIntegration.h"
#include "dynamics/step/islands/dxBodyWorkers.h"
#include "dynamics/step/islands/dxIslandSearch.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/islands/dxUserHandlers.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/step/random/dxRandom.h"
#include "dynamics/step/random/dxReservedDraws.h"
#include "settings/dxStepStatistics.h"
#include "settings/dxWorkersRunner.h"
#include "threading/dxPerturbation.h"

dxIslandParallelStep::dxIslandParallelStep(const dxStepCall &call, dxStepPlan &plan)
    : m_call(call),
      m_plan(plan),
      m_userHandlers(dxHasUserHandlers()),
      m_interrupted(call.count) {}

void dxIslandParallelStep::run() {
    const dxStopwatch stopwatch;
    if (!prepare()) {
        m_plan.reason = dODE_MT_REASON_MEMORY;
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
        stepRemainingIslands();
        finishPostponed();
        if (m_remote) m_plan.outcomes = m_remote->outcomes();
        m_remote.reset();
        learn(stopwatch.ns());
        rest = commit();
    }
    finishInOrder(rest);
}

// Where no two islands come before the first that has to be stepped in order.
void dxIslandParallelStep::noteOrder() {
    if (m_records->inOrderFrom >= 2 || m_records->inOrderFrom == m_call.count) return;
    const dxIsland &first = m_records->islands[m_records->inOrderFrom].island;
    m_plan.reason = dxHasMovedCallback(first) ? dODE_MT_REASON_MOVED_CALLBACK : dODE_MT_REASON_FEEDBACK;
}

// Changes nothing of the world's. Returns false if there is no memory for it.
bool dxIslandParallelStep::prepare() try {
    const dxTimelineSpan preparation(dxStepEvents::kIslandPreparation);
    m_records = dxStepRecords::borrow();
    dxPrepareIslands(m_call, m_plan.workers, *m_records);
    noteOrder();
    if (m_plan.remoteShare > 0)
        m_remote = std::make_unique<dxRemoteIslands>(m_call, *m_records, m_plan.remoteShare, m_plan.isRemoteForced);
    if (m_call.iterativeWorld != nullptr) m_call.iterativeWorld->provideSolvers(m_plan.workers);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

// Blocks are begun in their order: first the problems that remote workers solve are made, then come the islands that stay, then what
// the remote workers have to say.
void dxIslandParallelStep::runBlocks() {
    const unsigned made = m_remote ? m_remote->count() : 0, stepped = static_cast<unsigned>(m_records->blocks.size());
    const unsigned finished = m_remote ? m_plan.workers : 0;
    dxWorkersRunner(m_plan.workers, m_call.world)
        .forBlocks(dxParallelStage::Islands, made + stepped + finished, [this, made, stepped](unsigned block, unsigned worker) {
            if (block < made) return makeRemote(block, worker);
            if (block < made + stepped) return stepBlock(block - made, worker);
            finishRemote(worker);
        });
}

void dxIslandParallelStep::stepBlock(unsigned block, unsigned worker) {
    const dxStopwatch stopwatch;
    const dxIslandBlock range = m_records->blocks[block];
    double cost = 0;
    for (unsigned i = range.begin; i < range.end; ++i) {
        const dxIslandRecord &record = m_records->islands[m_records->order[i]];
        if (record.isRemote) continue;
        cost += record.cost;
        stepDeferred(m_records->order[i], worker);
        if (m_remote) m_remote->help();
    }
    const double ns = stopwatch.ns();
    m_records->workers[worker].busyNs += ns;
    if (m_remote) m_remote->noteStepped(cost, ns);
}

void dxIslandParallelStep::stepDeferred(unsigned index, unsigned worker) {
    dxPerturb(dxSchedulePoint::StepIsland);
    if (index > m_interrupted.load(std::memory_order_relaxed)) return;  // would be taken back
    dxIslandRecord &record = m_records->islands[index];
    dxWorkerRecord &own = m_records->workers[worker];
    if (!hasArena(worker) || !beginIsland(index, worker)) return;
    try {
        dxDeferredIsland scope(index, record.seed, m_userHandlers, own.reports);
        dxIslandStepper::step(m_call, record.island, own.arena);
        dxBodyWorkers::note(record.island, worker);
    } catch (const dxUpstreamInterrupted &) {
        dxPerturb(dxSchedulePoint::InterruptIsland);
        interruptAt(index);
    }
}

// Returns false if there is no memory.
bool dxIslandParallelStep::hasArena(unsigned worker) {
    dxWorkerRecord &own = m_records->workers[worker];
    if (own.arena == nullptr) own.arena = dxWorkingMemory::take(m_records->workers[0].arena->GetMemorySize());
    return own.arena != nullptr;
}

// Saves what is needed to take the island back. Returns false, and interrupts the step there, without memory for it.
bool dxIslandParallelStep::beginIsland(unsigned index, unsigned worker) {
    dxIslandRecord &record = m_records->islands[index];
    dxWorkerRecord &own = m_records->workers[worker];
    record.worker = record.finisher = worker;
    record.undoBegin = own.undo.mark();
    try {
        if (m_userHandlers) own.undo.save(record.island);
    } catch (const std::bad_alloc &) {
        interruptAt(index);
        return false;
    }
    record.undoEnd = own.undo.mark();
    record.stepped = true;
    ++own.islands;
    return true;
}

// --- islands that remote workers solve ------------------------------------------------------------------------

void dxIslandParallelStep::makeRemote(unsigned entry, unsigned worker) {
    const unsigned index = m_remote->islandOf(entry);
    if (index > m_interrupted.load(std::memory_order_relaxed)) return m_remote->drop(entry);
    if (!m_remote->prepare(entry)) {
        m_remote->drop(entry);
        return stepDeferred(index, worker);
    }
    if (!beginIsland(index, worker)) return m_remote->drop(entry);
    try {
        const dxDeferredIsland scope(index, m_records->islands[index].seed, m_userHandlers, m_records->workers[worker].reports);
        m_remote->make(entry);
    } catch (const dxUpstreamInterrupted &) {
        interruptAt(index);
    }
}

void dxIslandParallelStep::finishRemote(unsigned worker) {
    unsigned entry = 0;
    bool hasResult = false;
    for (dxRemoteBytes result; m_remote->next(entry, result, hasResult);) {
        if (hasResult || hasArena(worker))
            finishRemote(entry, worker, result, hasResult);
        else
            m_remote->postpone(entry);
        m_remote->help();
    }
}

void dxIslandParallelStep::finishRemote(unsigned entry, unsigned worker, const dxRemoteBytes &result, bool hasResult) {
    const unsigned index = m_remote->islandOf(entry);
    if (index > m_interrupted.load(std::memory_order_relaxed)) return;  // would be taken back
    dxIslandRecord &record = m_records->islands[index];
    dxWorkerRecord &own = m_records->workers[worker];
    record.finisher = worker;
    try {
        const dxDeferredIsland scope(index, record.seed, m_userHandlers, own.reports);
        m_remote->finish(entry, result, hasResult, own.arena);
        dxBodyWorkers::note(record.island, worker);
    } catch (const dxUpstreamInterrupted &) {
        interruptAt(index);
    }
}

void dxIslandParallelStep::finishPostponed() {
    for (unsigned entry = 0; m_remote && entry < m_remote->count(); ++entry)
        if (m_remote->isPostponed(entry)) finishRemote(entry, 0, {}, false);
}

void dxIslandParallelStep::interruptAt(unsigned island) { dxLowerTo(m_interrupted, island); }

void dxIslandParallelStep::stepRemainingIslands() {
    for (unsigned i = 0; i < m_records->inOrderFrom; ++i) {
        if (!m_records->islands[i].stepped) stepDeferred(i, 0);
    }
}

// Makes the steps of the islands visible in upstream's order, up to the first one that cannot be: one
// that has to be stepped in order, was interrupted, or has a geom in a space that is being collided.
// Returns that one.
unsigned dxIslandParallelStep::commit() {
    const dxTimelineSpan span(dxStepEvents::kCommit);
    dxPerturb(dxSchedulePoint::CommitIslands);
    unsigned end = std::min(m_records->inOrderFrom, m_interrupted.load(std::memory_order_relaxed));
    if (m_userHandlers) {
        for (unsigned i = 0; i < end; ++i) {
            if (dxTouchesLockedSpace(m_records->islands[i].island)) end = i;
        }
        takeBack(end);
    }
    for (unsigned i = 0; i < end; ++i) {
        deliverReports(i);
        dxNotifyMoved(m_records->islands[i].island);
    }
    deliverReports(end);
    giveArenasBack();
    return end;
}

void dxIslandParallelStep::takeBack(unsigned begin) {
    for (unsigned i = begin; i < m_records->inOrderFrom; ++i) {
        const dxIslandRecord &record = m_records->islands[i];
        if (!record.stepped) continue;
        m_records->workers[record.worker].undo.restore(record.undoBegin, record.undoEnd);
        for (unsigned k = 0; k < record.island.jointCount; ++k) record.island.joints[k]->tag = dxFoundTag;
    }
}

// Reports are kept only where the user has no handlers: a message goes to stderr, and an error ends the
// process, so an interrupted island is the last to report. Whoever stepped the island has them, and few
// islands have any.
void dxIslandParallelStep::deliverReports(unsigned island) const {
    if (island == m_call.count) return;
    const dxIslandRecord &record = m_records->islands[island];
    const auto deliver = [this, island](unsigned worker) {
        for (const dxKeptReport &report : m_records->workers[worker].reports)
            if (report.island == island) report.deliver();
    };
    deliver(record.worker);
    if (record.finisher != record.worker) deliver(record.finisher);
}

void dxIslandParallelStep::giveArenasBack() {
    unsigned islands = 0, used = 0;
    for (dxWorkerRecord &worker : m_records->workers) {
        islands += worker.islands;
        used += worker.islands != 0;
        if (&worker != &m_records->workers[0] && worker.arena) dxWorkingMemory::giveBack(worker.arena);
    }
    dxStepStatistics::instance().countParallelStep(islands, used);
}

void dxIslandParallelStep::finishInOrder(unsigned begin) {
    if (begin == m_call.count) return;
    const unsigned inOrderFrom = m_records->inOrderFrom;
    const bool reserved = dxIslandStepper::drawsRandomNumbers(m_call) && begin < inOrderFrom;
    const std::uint32_t seed = reserved ? m_records->islands[begin].seed : 0, end = m_records->randomEnd;
    const unsigned reservedCount = inOrderFrom - std::min(begin, inOrderFrom);
    m_records.reset();  // from here on user code runs, which may leave the step and never come back

    const dxSerialStep inOrder(m_call);
    dxIslandCursor cursor(m_call.info);
    for (unsigned i = 0; i < begin; ++i) cursor.next();
    if (reserved && !dxRandom::rewindShared(end, seed)) {
        dxReservedDraws draws(seed, end);
        inOrder.stepIslands(cursor, reservedCount);
        for (unsigned i = 0; i < reservedCount; ++i) cursor.next();
        begin = inOrderFrom;
    }
    inOrder.stepIslands(cursor, m_call.count - begin);
}

void dxIslandParallelStep::learn(double wallNs) const {
    if (m_records->inOrderFrom != m_call.count || m_interrupted.load(std::memory_order_relaxed) != m_call.count) return;
    double busyNs = 0;
    for (const dxWorkerRecord &worker : m_records->workers) busyNs += worker.busyNs;
    if (m_plan.remoteShare > 0) return learnFromHome(busyNs);
    dxCostModel::instance().learnParallel(m_call.kind, m_plan.costs.total, m_plan.costs.largest, m_plan.workers, busyNs,
                                          wallNs);
}

// Other processes were busy, too, so the step tells nothing of what sharing it out costs here: of the islands that stayed alone.
void dxIslandParallelStep::learnFromHome(double busyNs) const {
    double cost = 0;
    for (const dxIslandRecord &record : m_records->islands)
        if (!record.isRemote) cost += record.cost;
    dxCostModel::instance().learnSerial(m_call.kind, cost, busyNs);
}
