#include "dynamics/step/dxDeferredIslands.h"

#include <algorithm>
#include <new>

#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/islands/dxBodyMotion.h"
#include "dynamics/step/islands/dxBodyWorkers.h"
#include "dynamics/step/islands/dxIslandSearch.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "settings/dxProcessStatistics.h"
#include "threading/dxSchedulePoints.h"

void dxDeferredIslands::step(unsigned index, unsigned worker) {
    dxPerturb(dxSchedulePoint::StepIsland);
    if (!isNeeded(index)) return;
    dxWorldProcessMemArena *const arena = arenaOf(worker);
    if (arena == nullptr || !save(index, worker)) return;
    run(index, worker, [&] {
        const dxIsland &island = m_records.islands[index].island;
        dxIslandStepper::step(m_call, island, arena);
        dxBodyWorkers::note(island, worker);
    });
}

dxWorldProcessMemArena *dxDeferredIslands::arenaOf(unsigned worker) {
    dxWorkerRecord &own = m_records.workers[worker];
    if (own.arena == nullptr) own.arena = dxWorkingMemory::take(m_records.workers[0].arena->GetMemorySize());
    return own.arena;
}

bool dxDeferredIslands::save(unsigned index, unsigned worker) {
    dxIslandRecord &record = m_records.islands[index];
    dxWorkerRecord &own = m_records.workers[worker];
    record.worker = worker;
    record.undoBegin = own.undo.mark();
    try {
        if (m_records.run.hasUserHandlers()) own.undo.save(record.island);
    } catch (const std::bad_alloc &) {
        m_records.run.interruptAt(index);
        return false;
    }
    record.undoEnd = own.undo.mark();
    record.stepped = true;
    ++own.islands;
    return true;
}

void dxDeferredIslands::stepRest() {
    for (unsigned i = 0; i < m_records.inOrderFrom; ++i) {
        if (!m_records.islands[i].stepped) step(i, 0);
    }
}

unsigned dxDeferredIslands::commit() {
    const dxTimelineSpan span(dxStepEvents::kCommit);
    dxPerturb(dxSchedulePoint::CommitIslands);
    const unsigned end = findEnd();
    takeBack(end);
    m_records.run.commit(end, [this](unsigned island) { dxNotifyMoved(m_records.islands[island].island); });
    giveArenasBack();
    return end;
}

unsigned dxDeferredIslands::findEnd() const {
    const unsigned end = std::min(m_records.inOrderFrom, m_records.run.interrupted());
    if (!m_records.run.hasUserHandlers()) return end;
    for (unsigned i = 0; i < end; ++i)
        if (dxTouchesLockedSpace(m_records.islands[i].island)) return i;
    return end;
}

// Nothing is saved where the user has no handlers: an error ends the process then.
void dxDeferredIslands::takeBack(unsigned begin) {
    if (!m_records.run.hasUserHandlers()) return;
    for (unsigned i = begin; i < m_records.inOrderFrom; ++i) {
        const dxIslandRecord &record = m_records.islands[i];
        if (!record.stepped) continue;
        m_records.workers[record.worker].undo.restore(record.undoBegin, record.undoEnd);
        for (unsigned k = 0; k < record.island.jointCount; ++k) record.island.joints[k]->tag = dxFoundTag;
    }
}

void dxDeferredIslands::giveArenasBack() {
    unsigned islands = 0, used = 0;
    for (dxWorkerRecord &worker : m_records.workers) {
        islands += worker.islands;
        used += worker.islands != 0;
        if (&worker != &m_records.workers[0] && worker.arena) dxWorkingMemory::giveBack(worker.arena);
    }
    dxProcessStatistics::instance().countParallelStep(islands, used);
}
