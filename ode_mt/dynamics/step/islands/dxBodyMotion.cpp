#include "dynamics/step/islands/dxBodyMotion.h"

#include <ode/odemath.h>

#include "dynamics/step/islands/dxBodyIntegration.h"
#include "dynamics/step/islands/dxForBodies.h"
#include "dynamics/step/islands/dxUserHandlers.h"

namespace {

void clearForces(dxBody &body) {
    dZeroVector3(body.facc);
    dZeroVector3(body.tacc);
}

}  // namespace

dxNotificationPolicy::dxNotificationPolicy(const dxIslandStep &step)
    : m_mayDefer(step.islandWorkers != nullptr && !(dxHasUserHandlers() && dxTouchesLockedSpace(step.island))) {}

void dxNotificationPolicy::add(const dxBody &body) {
    if (mayDefer() && !dxMovesQuietly(body)) m_mayDefer.store(false, std::memory_order_relaxed);
}

void dxMoveBodies(const dxIslandStep &step, const dxNotificationPolicy &notifications) {
    if (notifications.mayDefer()) {
        dxForBodiesInParallel(step, dxParallelStage::Motion, [&](std::size_t i) {
            dxBody &body = *step.island.bodies[i];
            dxIntegrateUntold(&body, step.stepSize);
            clearForces(body);
        });
        return dxNotifyMoved(step.island);
    }
    dxForBodies(step, [&](std::size_t i) {
        dxBody &body = *step.island.bodies[i];
        dxIntegrateIslandBody(&body, step.stepSize);
        clearForces(body);
    });
}
