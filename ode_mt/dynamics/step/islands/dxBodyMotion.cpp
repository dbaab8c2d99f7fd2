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

dxQuietMotion::dxQuietMotion(const dxIslandStep &step)
    : m_isQuiet(step.islandWorkers != nullptr && !(dxHasUserHandlers() && dxTouchesLockedSpace(step.island))) {}

void dxQuietMotion::see(const dxBody &body) {
    if (isQuiet() && !dxMovesQuietly(body)) m_isQuiet.store(false, std::memory_order_relaxed);
}

void dxMoveBodies(const dxIslandStep &step, const dxQuietMotion &motion) {
    if (motion.isQuiet()) {
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
