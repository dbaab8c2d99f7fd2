/* QuickStep's shuffle of the rows and its sweep over them are ours (ode_mt/dynamics). Upstream's are static functions in
 * the same file as their calls, so the two are told apart by their argument: a definition's begins with a type, a
 * call's is a variable. The definitions get other names and are not used. */
#pragma once

#include "../../ode_mt/dynamics/dxRowShuffle.h"
#include "../../ode_mt/dynamics/sweep/dxSweep.h"

#define dxQuickStepIsland_Stage4LCP_ConstraintsShuffling(argument, iteration) dxShuffleSeam_##argument, iteration)
#define dxShuffleSeam_dxQuickStepperStage4CallContext dxUpstreamShuffle(dxQuickStepperStage4CallContext
#define dxShuffleSeam_stage4CallContext dxShuffleCall(stage4CallContext

#define dxQuickStepIsland_Stage4LCP_STIteration(argument) dxSweepSeam_##argument)
#define dxSweepSeam_dxQuickStepperStage4CallContext dxUpstreamSweep(dxQuickStepperStage4CallContext
#define dxSweepSeam_stage4CallContext dxSweepCall(stage4CallContext

/* As upstream: before the first iteration the rows stay in the order of their joints. The mark tells that they
 * no longer are. */
template <class Call>
bool dxShuffleCall(Call *call, unsigned iteration) {
    if (iteration != 0) {
        dxShuffleRows(&call->m_order->index, call->m_localContext->m_m);
        call->m_SOR_reorderHeadTaken = 1;
    }
    return true;
}

/* Until the first shuffle the order is made to overlap, once. The schedule lies in memory that upstream reserves for
 * threads of its own, of which there are none here, and so does the mark that it is made. */
template <class Call>
void dxSweepCall(Call *call) {
    const auto *local = call->m_localContext;
    const dxSweepIsland island = {local->m_m,
                                  call->m_stepperCallContext->m_islandBodiesCount,
                                  local->m_J,
                                  call->m_iMJ,
                                  reinterpret_cast<const int *>(local->m_jb),
                                  local->m_findex,
                                  call->m_lambda,
                                  call->m_cforce};
    const int *order = &call->m_order->index;
    if (call->m_SOR_reorderHeadTaken == 0) {
        int *scheduled = reinterpret_cast<int *>(call->m_mi_links);
        if (call->m_SOR_mi_zeroHeadTaken == 0) {
            unsigned *level = reinterpret_cast<unsigned *>(scheduled + island.rows);
            dxScheduleSweep(island, order, {scheduled, level, reinterpret_cast<unsigned *>(call->m_bi_links_or_mi_levels)});
            call->m_SOR_mi_zeroHeadTaken = 1;
        }
        order = scheduled;
    }
    dxSweep(island, order);
}
