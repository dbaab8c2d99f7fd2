/* QuickStep's sweep over the rows is ours (ode_mt/dynamics/sweep). Upstream's is a static function in the same file
 * as its call, so the two are told apart by their argument: the definition's begins with a type, the call's is a
 * variable. The definition gets another name and is not used. */
#pragma once

#include "../../ode_mt/dynamics/sweep/dxSweep.h"

#define dxQuickStepIsland_Stage4LCP_STIteration(argument) dxSweepSeam_##argument)
#define dxSweepSeam_dxQuickStepperStage4CallContext dxUpstreamSweep(dxQuickStepperStage4CallContext
#define dxSweepSeam_stage4CallContext dxSweepCall(stage4CallContext

/* Upstream marks an order as shuffled; until then the rows are in the order of their joints, which is made to
 * overlap once. The schedule lies in memory that upstream reserves for threads of its own, of which there are none
 * here, and so does the mark that it is made. */
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
