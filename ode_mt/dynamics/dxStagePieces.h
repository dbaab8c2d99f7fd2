// Upstream's stages of QuickStep in pieces: a piece is the stage for a range of bodies, joints or rows, and any worker
// may take it; without a team the caller takes them in order. Pieces of pieces fetch the next bodies and joints
// (docs/memory.md). ode/seams/quickstep.h calls these in the place of the stages.
//
// A stage counts through its items, from a counter in its context to a length in the island's. A piece is the
// stage with copies of both, in which the counter starts at the piece and the length ends with it, so that workers do
// not contend for one counter. No item reads what another one of its stage writes (docs/teams.md).
//
// Templates, because the contexts are known in upstream's file alone.
#pragma once

#include <atomic>
#include <cstddef>

#include "dynamics/dxFetchAhead.h"
#include "dynamics/dxIslandCall.h"
#include "joints/joint.h"

namespace dxStagePieces {

// Items that one worker takes at once: some ten microseconds.
constexpr std::size_t kBodies = 32, kJoints = 32, kRows = 256;

// Rows that upstream's counter counts at once (dxQUICKSTEPISLAND_STAGE2C_STEP).
constexpr unsigned kRhsStep = 32;

// Upstream's inverse inertia of a body: three rows of four.
constexpr std::size_t kInertia = 12;

// getInfo2 of other joints may push their bodies (motors at their limits), which has to go in order.
inline bool hasOnlyContacts(const dxStepperProcessingCallContext &island) {
    for (unsigned i = 0; i < island.m_islandJointsCount; ++i)
        if (island.m_islandJointsStart[i]->type() != dJointTypeContact) return false;
    return true;
}

inline bool hasTeam(const dxStepperProcessingCallContext &island) { return dxIslandCall::of(&island).team != nullptr; }

// An island whose bodies and joints have to come from far caches, or that is shared out, is taken in pieces.
inline bool isWhole(const dxStepperProcessingCallContext &island) {
    return island.m_islandBodiesCount < dxFetchAhead::kLeastBodies && !hasTeam(island);
}

// The island with the bodies [begin, end) alone.
inline dxStepperProcessingCallContext bodiesOf(const dxStepperProcessingCallContext &island, std::size_t begin,
                                               std::size_t end) {
    dxStepperProcessingCallContext part = island;
    part.m_islandBodiesStart += begin;
    part.m_islandBodiesCount = static_cast<unsigned>(end - begin);
    return part;
}

// Calls work(begin, end) for small pieces of the bodies [begin, end), the next ones being fetched: those after `end`, too,
// unless another worker may be at them.
template <class Work>
void forBodies(const dxStepperProcessingCallContext &island, std::size_t begin, std::size_t end, const Work &work) {
    dxBody *const *const bodies = island.m_islandBodiesStart;
    dxFetchAhead::forPieces(begin, end, hasTeam(island) ? end : island.m_islandBodiesCount,
                            [bodies](std::size_t i) { dxFetchAhead::body(bodies[i]); }, work);
}

// Tags, gravity and inertia.
template <class Stage, class Call>
void prepareBodies(Stage stage, Call *call) {
    const dxStepperProcessingCallContext &whole = *call->m_stepperCallContext;
    if (isWhole(whole)) return stage(call);
    const auto prepare = [&](std::size_t begin, std::size_t end) {
        const dxStepperProcessingCallContext island = bodiesOf(whole, begin, end);
        for (std::size_t i = begin; i < end; ++i) whole.m_islandBodiesStart[i]->tag = static_cast<int>(i);
        Call piece = *call;
        piece.m_stepperCallContext = &island;
        piece.m_invI += begin * kInertia;
        piece.m_tagsTaken = 1;
        stage(&piece);
    };
    dxIslandCall::of(&whole).runner().forPieces(dxParallelStage::Bodies, whole.m_islandBodiesCount, kBodies,
        [&](std::size_t begin, std::size_t end, unsigned) {
        forBodies(whole, begin, end, prepare);
    });
}

// Jacobians and limits of the joints.
template <class Stage, class Call>
void readJoints(Stage stage, Call *call) {
    const dxStepperProcessingCallContext &island = *call->m_stepperCallContext;
    if (isWhole(island)) return stage(call);
    auto &whole = *call->m_localContext;
    const auto *const infos = whole.m_jointinfos;
    std::atomic<unsigned> bounded{0};
    const bool isShared = hasTeam(island) && hasOnlyContacts(island);
    dxTaskRunner &runner = isShared ? dxIslandCall::of(&island).runner() : dxTaskRunner::alone();
    runner.forPieces(dxParallelStage::Joints, whole.m_nj, kJoints, [&](std::size_t begin, std::size_t end, unsigned) {
        auto local = whole;
        local.m_valid_findices = 0;
        Call piece = *call;
        piece.m_localContext = &local;
        const auto read = [&](std::size_t first, std::size_t last) {
            local.m_nj = static_cast<unsigned>(last);
            piece.m_ji_J = piece.m_ji_jb = static_cast<unsigned>(first);
            stage(&piece);
        };
        dxFetchAhead::forPieces(begin, end, whole.m_nj, [infos](std::size_t i) { dxFetchAhead::joint(infos[i].joint); }, read);
        bounded.fetch_add(local.m_valid_findices, std::memory_order_relaxed);
    });
    whole.m_valid_findices += bounded.load(std::memory_order_relaxed);
}

// Right-hand sides from velocities.
template <class Stage, class Call>
void addRightHandSides(Stage stage, Call *call) {
    const dxStepperProcessingCallContext &island = *call->m_stepperCallContext;
    if (!hasTeam(island)) return stage(call);
    const auto &whole = *call->m_localContext;
    dxIslandCall::of(&island).runner().forPieces(dxParallelStage::RightHandSides, whole.m_m, kRows,
        [&](std::size_t begin, std::size_t end, unsigned) {
        auto local = whole;
        local.m_m = static_cast<unsigned>(end);
        Call piece = *call;
        piece.m_localContext = &local;
        piece.m_Jrhsi = static_cast<unsigned>(begin) / kRhsStep;
        stage(&piece);
    });
}

// Positions and moved-callbacks, which stay on the caller, in order.
template <class Stage, class Call>
void moveBodies(Stage stage, Call *call) {
    const dxStepperProcessingCallContext &whole = *call->m_stepperCallContext;
    if (isWhole(whole)) return stage(call);
    forBodies(whole, 0, whole.m_islandBodiesCount, [&](std::size_t begin, std::size_t end) {
        const dxStepperProcessingCallContext island = bodiesOf(whole, begin, end);
        Call piece = *call;
        piece.m_stepperCallContext = &island;
        stage(&piece);
    });
}

}  // namespace dxStagePieces
