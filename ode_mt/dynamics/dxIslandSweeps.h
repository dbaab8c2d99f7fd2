// QuickStep's sweeps over an island, in upstream's loop of iterations. ode/seams/quickstep.h calls these.
//
// Templates, because the context is known in upstream's file alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>

#include <ode/odemath.h>

#include "dynamics/dxIslandCall.h"
#include "dynamics/dxRowShuffle.h"
#include "dynamics/sweep/dxSweep.h"

namespace dxIslandSweeps {

// Upstream shuffles the rows before every eighth sweep but the first.
constexpr unsigned kShuffleEvery = 8;

constexpr std::size_t kRowPiece = 256;  // rows that one worker packs at once

template <class Call>
dxSweepIsland islandOf(const Call &call) {
    const auto &local = *call.m_localContext;
    return {local.m_m,
            call.m_stepperCallContext->m_islandBodiesCount,
            local.m_J,
            call.m_iMJ,
            reinterpret_cast<const int *>(local.m_jb),
            local.m_findex,
            call.m_lambda,
            call.m_cforce,
            dxIslandCall::of(call.m_stepperCallContext).rows.get()};
}

// --- preparation --------------------------------------------------------------------------------------

template <class Call>
bool isLarge(const Call &call) {
    return call.m_localContext->m_m >= dxSweepIsland::kLarge;
}

// inv(M) J^T, and the Jacobian scaled by the diagonal of J inv(M) J^T.
inline void packRow(dReal *jacobian, dxSweepRow &row, const dReal *invMass, const dReal *const *invInertia,
                    dReal w) {
    const int bodies = row.body[1] != dxSweepIsland::kNone ? 2 : 1;
    dReal sum = 0;
    for (int body = 0; body < bodies; ++body) {
        const dReal *const own = jacobian + (body == 0 ? dxSweepIsland::kBody1 : dxSweepIsland::kBody2);
        dReal *const impulse = row.impulse + (body == 0 ? dxSweepIsland::kOn1 : dxSweepIsland::kOn2);
        for (int i = 0; i < 3; ++i) impulse[i] = invMass[body] * own[i];
        dMultiply0_331(impulse + 3, invInertia[body], own + 3);
        for (int i = 0; i < 6; ++i) sum += impulse[i] * own[i];
    }
    const dReal cfm = jacobian[dxSweepIsland::kCfm], scale = w / (sum + cfm);
    jacobian[dxSweepIsland::kCfm] = cfm * scale;
    jacobian[dxSweepIsland::kRhs] *= scale;
    for (int i = 0; i < 6; ++i) jacobian[dxSweepIsland::kBody1 + i] *= scale;
    if (bodies == 2)
        for (int i = 0; i < 6; ++i) jacobian[dxSweepIsland::kBody2 + i] *= scale;
}

template <class Call>
void packRows(const Call &call, dxSweepRow *rows, std::size_t begin, std::size_t end) {
    constexpr std::size_t kInertia = 12;  // upstream's inverse inertia of a body: three rows of four
    const auto &local = *call.m_localContext;
    const dxStepperProcessingCallContext &context = *call.m_stepperCallContext;
    for (std::size_t i = begin; i < end; ++i) {
        dxSweepRow &row = rows[i];
        row.body[0] = local.m_jb[i].first;
        row.body[1] = local.m_jb[i].second;
        row.boundingRow = local.m_findex[i];
        row.lambda = call.m_lambda[i];
        dReal invMass[2];
        const dReal *invInertia[2];
        for (int body = 0; body < 2 && row.body[body] != dxSweepIsland::kNone; ++body) {
            const auto number = static_cast<std::size_t>(row.body[body]);
            invMass[body] = context.m_islandBodiesStart[number]->invMass;
            invInertia[body] = local.m_invI + number * kInertia;
        }
        packRow(local.m_J + i * dxSweepIsland::kJacobianColumns, row, invMass, invInertia,
                context.m_world->qs.w);
    }
}

// The rows of a large island are packed as they are prepared, if there is memory for that: upstream's two
// stages do the same operations on each row, one stage after the other.
template <class Stage, class Call>
void computeImpulses(Stage stage, Call *call) {
    const dxIslandCall &island = dxIslandCall::of(call->m_stepperCallContext);
    dxSweepRow *const rows = isLarge(*call) ? island.rows.take(call->m_localContext->m_m) : nullptr;
    if (rows == nullptr) return stage(call);
    island.runner().forPieces(
        dxParallelStage::Rows, call->m_localContext->m_m, kRowPiece,
        [&](std::size_t begin, std::size_t end, unsigned) { packRows(*call, rows, begin, end); });
}

template <class Stage, class Call>
void scaleRows(Stage stage, Call *call) {
    if (dxIslandCall::of(call->m_stepperCallContext).rows.get() == nullptr) stage(call);
}

// Upstream reads the results where there is feedback.
template <class Call>
void giveResults(Call *call) {
    dxRowMemory &rows = dxIslandCall::of(call->m_stepperCallContext).rows;
    const auto &local = *call->m_localContext;
    if (rows.get() != nullptr && local.m_mfb != 0)
        for (std::size_t i = 0; i < local.m_m; ++i) call->m_lambda[i] = rows.get()[i].lambda;
    rows.giveBack();
}

// --- sweeps -------------------------------------------------------------------------------------------

// Whether the rows are no longer in the order of their joints. The mark is one that upstream's threads would
// use.
template <class Call>
bool isShuffled(const Call &call) {
    return call.m_SOR_reorderHeadTaken != 0;
}

// In how many parts the team takes the rows, which are packed; below two the caller takes them alone.
template <class Call>
unsigned partsOf(const Call &call) {
    const dxIslandCall &island = dxIslandCall::of(call.m_stepperCallContext);
    if (island.team == nullptr || island.rows.get() == nullptr) return 1;
    return std::min(island.team->runner->workers(), call.m_localContext->m_m / dxSharedSweep::kLeastRows);
}

template <class Call>
void cut(const Call &call, dxIslandTeam &team, unsigned parts) {
    dxBody *const *const bodies = call.m_stepperCallContext->m_islandBodiesStart;
    const dxSweepIsland island = islandOf(call);
    team.sweep.begin(island, parts, [bodies](std::size_t body) { return bodies[body]->posr.pos; });
}

// The rows in the order in which they are to be taken. Until the first shuffle that is made to overlap, once:
// the schedule lies in memory that upstream reserves for threads of its own, of which there are none here,
// and so does the mark that it is made.
template <class Call>
const int *orderOf(Call *call) {
    if (isShuffled(*call)) return &call->m_order->index;
    int *const scheduled = reinterpret_cast<int *>(call->m_mi_links);
    if (call->m_SOR_mi_zeroHeadTaken == 0) {
        const dxSweepIsland island = islandOf(*call);
        unsigned *const level = reinterpret_cast<unsigned *>(scheduled + island.rows);
        dxScheduleSweep(island, &call->m_order->index,
                        {scheduled, level, reinterpret_cast<unsigned *>(call->m_bi_links_or_mi_levels)});
        call->m_SOR_mi_zeroHeadTaken = 1;
    }
    return scheduled;
}

// All sweeps from number `sweep` up to the next shuffle. Without memory to plan them, before which nothing is
// swept, the caller sweeps alone from here on.
template <class Call>
void sweepByTeam(Call *call, unsigned sweep, unsigned parts) {
    const dxIslandCall &island = dxIslandCall::of(call->m_stepperCallContext);
    dxIslandTeam &team = *island.team;
    const unsigned all = static_cast<unsigned>(call->m_stepperCallContext->m_world->qs.num_iterations);
    try {
        if (sweep == 0) cut(*call, team, parts);
        team.sweep.sweep(islandOf(*call), orderOf(call), std::min(kShuffleEvery, all - sweep), *team.runner);
    } catch (const std::bad_alloc &) {
        island.team = nullptr;
    }
}

// Before sweep number `sweep`, the first and every eighth.
template <class Call>
bool shuffle(Call *call, unsigned sweep) {
    if (sweep > 0) {
        dxShuffleRows(&call->m_order->index, call->m_localContext->m_m);
        call->m_SOR_reorderHeadTaken = 1;
    }
    const unsigned parts = partsOf(*call);
    if (parts >= 2) sweepByTeam(call, sweep, parts);
    return true;
}

// One sweep, unless a team has made it already.
template <class Call>
void sweep(Call *call) {
    if (partsOf(*call) < 2) dxSweep(islandOf(*call), orderOf(call));
}

}  // namespace dxIslandSweeps
