#include "dynamics/iterative/dxIterativeStep.h"

#include <new>

#include "dynamics/iterative/dxIterativeWorld.h"
#include "dynamics/iterative/dxOtherJoints.h"
#include "dynamics/quickstep/dxIslandBodies.h"
#include "dynamics/quickstep/dxQuickStep.h"

namespace {

void numberBodies(const dxIsland &group) {
    for (unsigned i = 0; i < group.bodyCount; ++i) group.bodies[i]->tag = static_cast<int>(i);
}

// Returns false if there is no memory; nothing of the bodies has changed then.
bool solve(const dxIslandStep &step) try {
    numberBodies(step.island);
    const dxIterativeWorld::Lease solver(*step.iterativeWorld);
    solver->begin(step);
    auto *const bodies = step.arena->AllocateArray<dxIslandBody>(step.island.bodyCount);
    dxGatherBodies(step, bodies);                      // parallel
    const dxOtherJoints joints(step, solver->plan());  // serial
    solver->solve(step, bodies, joints);               // parallel
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

}  // namespace

void dxIterativeStep(const dxIslandStep &step) {
    if (step.iterativeWorld == nullptr || !solve(step)) return dxQuickStep(step);
    dxMoveBodies(step);  // serial: tells spaces and the user
}
