// The islands of a step, for tests that step them stage by stage.
#pragma once

#include <gtest/gtest.h>

#include "config.h"
#include "util.h"

#include "dynamics/step/islands/dxIsland.h"
#include "dynamics/step/islands/dxIslandSearch.h"

// Calls visit(island, arena) for each, in memory of the size that the estimate asks for.
template <class Visit>
void forIslands(dxWorld *world, dReal stepSize, dmemestimate_fn_t estimate, const Visit &visit) {
    dxWorldProcessIslandsInfo info;
    ASSERT_TRUE(dxPrepareStep(world, info, stepSize, estimate));
    dxWorldProcessContext *const context = world->unsafeGetWorldProcessingContext();
    dxWorldProcessMemArena *const arena = context->ObtainStepperMemArena();
    dxIslandCursor cursor(info);
    for (sizeint i = 0; i < info.GetIslandsCount(); ++i) {
        arena->ResetState();
        visit(cursor.next(), arena);
        if (testing::Test::HasFatalFailure()) break;
    }
    context->ReturnStepperMemArena(arena);
}
