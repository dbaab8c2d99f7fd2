#include "dynamics/step/islands/dxBodyMotion.h"

#include <ode/collision.h>
#include <ode/odemath.h>

#include <utility>

#include "collision_kernel.h"
#include "collision_space_internal.h"
#include "core/dxPrefetch.h"
#include "dynamics/step/islands/dxBodyForces.h"
#include "dynamics/step/islands/dxForBodies.h"
#include "dynamics/step/random/dxSingleStepper.h"
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

// What dGeomMoved reads and writes.
void prefetchMove(const dxGeom *geom) {
    if (geom == nullptr) return;
    dxPrefetch::lineForWrite(&geom->gflags);
    dxPrefetch::lineForWrite(&geom->next);
}

// Moves a body and damps it, but notifies no space. Any thread; writes the body alone.
void integrateUntold(dxBody *body, dReal stepSize) {
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

}  // namespace

void dxIntegrateIslandBody(dxBody *body, dReal stepSize) {
    const dxUpstreamScope *scope = dxUpstreamScope::current();
    if (scope == nullptr || !scope->defersMoved()) {
        stepBody(body, stepSize);
        return;
    }
    integrateUntold(body, stepSize);
}

// Upstream asserts that the quaternion, to which half of its product with the angular velocity has been added, has a length.
bool dxMayDeferNotification(const dxBody &body) {
    if (body.moved_callback != nullptr || (body.flags & dxBodyFlagFiniteRotation) != 0) return false;
    const dReal length = dCalcVectorDot3(body.q, body.q) + body.q[3] * body.q[3], speed = dCalcVectorDot3(body.avel, body.avel);
    return length > dReal(0.25) && length < 4 && speed < dReal(1e15);
}

void dxNotifyMoved(const dxIsland &island) {
    constexpr unsigned kBodyPrefetchDistance = 16, kGeomPrefetchDistance = 8;
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        if (i + kBodyPrefetchDistance < island.bodyCount) dxPrefetch::line(&island.bodies[i + kBodyPrefetchDistance]->geom);
        if (i + kGeomPrefetchDistance < island.bodyCount) prefetchMove(island.bodies[i + kGeomPrefetchDistance]->geom);
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

dxNotificationPolicy::dxNotificationPolicy(const dxIslandStep &step)
    : m_mayDefer(step.islandWorkers != nullptr && !(dxHasUserHandlers() && dxTouchesLockedSpace(step.island))) {}

void dxNotificationPolicy::add(const dxBody &body) {
    if (mayDefer() && !dxMayDeferNotification(body)) m_mayDefer.store(false, std::memory_order_relaxed);
}

void dxMoveBodies(const dxIslandStep &step, const dxNotificationPolicy &notifications) {
    if (notifications.mayDefer()) {
        dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
            dxBody &body = *step.island.bodies[i];
            integrateUntold(&body, step.stepSize);
            dxClearForces(body);
        });
        return dxNotifyMoved(step.island);
    }
    dxForBodies(step, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        dxIntegrateIslandBody(&body, step.stepSize);
        dxClearForces(body);
    });
}
