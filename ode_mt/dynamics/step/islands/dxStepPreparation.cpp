#include "dynamics/step/islands/dxStepPreparation.h"

#include <algorithm>

#include "dynamics/step/islands/dxIslandSearch.h"
#include "upstream_facts.h"

namespace {

// What dxFindIslands takes: sizes and lists of the islands, and the bodies from which the search has yet to go on.
sizeint searchMemory(const dxWorld &world) {
    const auto bodies = static_cast<sizeint>(world.nb), joints = static_cast<sizeint>(world.nj);
    const sizeint bodyList = dEFFICIENT_SIZE(bodies * sizeof(dxBody *)), jointList = dEFFICIENT_SIZE(joints * sizeof(dxJoint *));
    return dEFFICIENT_SIZE(2 * bodies * sizeof(unsigned)) + bodyList + jointList + std::min(bodyList, jointList);
}

// Upstream keeps the call for an island in the arena, too, and with it the call of the step, the island's number and the
// arena with its state.
constexpr sizeint kIslandCallSize = dEFFICIENT_SIZE(3 * sizeof(void *) + sizeof(sizeint) + sizeof(dxStepperProcessingCallContext));

// The arena of islands is as large as needed, whatever the user's reserve for steppers.
constexpr float kNoReserve = 1;

}  // namespace

bool dxPrepareStep(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate) {
    return dxPrepareGroups(world, info, stepSize, estimate, {});
}

bool dxPrepareGroups(dxWorld *world, dxWorldProcessIslandsInfo &info, dReal stepSize, dmemestimate_fn_t estimate, const dxGroupSizes &groupSizes) {
    dxStepWorkingMemory *const memory = AllocateOnDemand(world->wmem);
    if (memory == nullptr) return false;
    dxWorldProcessContext *const context = memory->SureGetWorldProcessingContext();
    if (context == nullptr || !context->EnsureStepperSyncObjectsAreAllocated(world)) return false;

    const dxWorldProcessMemoryReserveInfo &reserve = *memory->SureGetMemoryReserveInfo();
    const dxWorldProcessMemoryManager *const manager = memory->SureGetMemoryManager();
    dxWorldProcessMemArena *const islands =
        context->ReallocateIslandsMemArena(searchMemory(*world), manager, kNoReserve, reserve.m_uiReserveMinimum);
    if (islands == nullptr) return false;

    const sizeint stepper = dxFindIslands(info, islands, world, stepSize, estimate, groupSizes);
    return context->ReallocateStepperMemArenas(world, dxIslandThreads(*world),
                                               stepper + kIslandCallSize, manager, reserve.m_fReserveFactor,
                                               reserve.m_uiReserveMinimum);
}
