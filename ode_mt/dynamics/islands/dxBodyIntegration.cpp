#include "dynamics/islands/dxBodyIntegration.h"

#include <ode/collision.h>

#include <utility>

#include "collision_kernel.h"
#include "collision_space_internal.h"
#include "dynamics/random/dxSingleStepper.h"
#include "threading/dxUpstreamScope.h"

namespace {

void stepBody(dxBody *body, dReal stepSize) {
    if (body->moved_callback == nullptr) {
        dxStepBody(body, stepSize);
        return;
    }
    const dxSingleStepper::UserCode userCode;
    dxStepBody(body, stepSize);
}

}  // namespace

void dxIntegrateIslandBody(dxBody *body, dReal stepSize) {
    const dxUpstreamScope *scope = dxUpstreamScope::current();
    if (scope == nullptr || !scope->defersMoved()) {
        stepBody(body, stepSize);
        return;
    }
    // A body without geoms notifies no space. Nothing else reads the list while the island is stepped.
    const dGeomID geoms = std::exchange(body->geom, nullptr);
    try {
        dxStepBody(body, stepSize);
    } catch (...) {
        body->geom = geoms;
        throw;
    }
    body->geom = geoms;
}

void dxNotifyMoved(const dxIsland &island) {
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        for (dxGeom *geom = island.bodies[i]->geom; geom; geom = geom->body_next) dGeomMoved(geom);
    }
}

bool dxTouchesLockedSpace(const dxIsland &island) {
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        for (const dxGeom *geom = island.bodies[i]->geom; geom; geom = geom->body_next) {
            for (const dxSpace *space = geom->parent_space; space; space = space->parent_space) {
                if (space->lock_count != 0) return true;
            }
        }
    }
    return false;
}
