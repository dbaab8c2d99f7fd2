// The stages of upstream's QuickStep, one after the other, with what each leaves behind.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "dynamics/step/islands/dxIsland.h"

struct UpstreamQuickStep {
    std::vector<dReal> invInertia;           // bodies x 12
    std::vector<dReal> forces;               // bodies x 6, after gravity and gyroscopic torques
    std::vector<dReal> jacobian;             // rows x 16, as the joints give it
    std::vector<int> boundingRow, bodies;    // rows, rows x 2
    std::vector<dReal> freeAcceleration;     // bodies x 6
    std::vector<dReal> impulse;              // rows x 12
    std::vector<dReal> scaledJacobian;       // rows x 16
    std::vector<int> order;                  // rows, before the first shuffle
    std::vector<dReal> lambda, acceleration; // rows, bodies x 6
};

// Steps the island by upstream's stages.
UpstreamQuickStep stepByUpstream(dxWorld *world, dReal stepSize, const dxIsland &island);
