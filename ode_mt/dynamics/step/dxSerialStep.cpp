#include "dynamics/step/dxSerialStep.h"

#include <optional>

#include "dynamics/step/dxIslandStepper.h"
#include "dynamics/step/islands/dxWorkingMemory.h"
#include "dynamics/step/islands/dxBodyWorkers.h"
#include "dynamics/step/islands/dxIslandSurvey.h"
#include "dynamics/step/islands/dxStepTimeline.h"
#include "dynamics/step/random/dxRandom.h"
#include "dynamics/step/random/dxIslandDraws.h"
#include "dynamics/step/random/dxSingleStepper.h"

void dxSerialStep::run() const {
    dxIslandCursor cursor(m_call.info);
    if (!dxIslandStepper::drawsRandomNumbers(m_call)) {
        stepIslands(cursor, m_call.count);
        return;
    }
    const dxSingleStepper stepper;
    if (stepper.alone()) {
        stepIslands(cursor, m_call.count);
    } else {
        runReserving();
    }
}

void dxSerialStep::runReserving() const {
    // Nothing can see the random sequence before the first callback of the user: the islands until there take
    // their numbers as one block.
    std::uint64_t draws = 0;
    unsigned quiet = 0;
    for (dxIslandCursor cursor(m_call.info); quiet < m_call.count; ++quiet) {
        const dxIsland island = cursor.next();
        if (dxHasMovedCallback(island)) break;
        const std::optional<unsigned> rows = dxCountRows(island);
        if (!rows) break;
        draws += dxIslandStepper::drawsOf(m_call, *rows);
    }
    dxIslandCursor cursor(m_call.info);
    if (quiet > 0) {
        const std::uint32_t seed = dxRandom::takeSharedBlock(draws);
        dxReservedDraws reserved(seed, dxRandom::jump(seed, draws));
        stepIslands(cursor, quiet);
    }
    stepIslands(cursor, m_call.count - quiet);
}

void dxSerialStep::stepIslands(dxIslandCursor &cursor, unsigned count) const {
    if (count == 0) return;
    dxTimelineSpan inOrder(dxStepEvents::kIslandsInOrder);
    inOrder.set(0, count);
    const dxWorldArena arena(m_call.world);
    for (unsigned i = 0; i < count; ++i) {
        const dxIsland island = cursor.next();
        const bool isLarge = m_islandWorkers != nullptr && island.jointCount >= m_minLargeJoints;
        dxIslandStepper::step(m_call, island, arena.get(), isLarge ? m_islandWorkers : nullptr);
        dxBodyWorkers::note(island, m_worker);
    }
}
