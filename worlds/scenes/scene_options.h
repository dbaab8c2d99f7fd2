// What the description of a scene, "pile:4000,quick,sap", says.
#pragma once

#include "scenes/scene.h"

namespace scenes {

enum class SpaceKind { Simple, Hash, SweepAndPrune, QuadTree };

struct SceneOptions {
    int size = 1;
    Stepper stepper = Stepper::Quick;
    SpaceKind space = SpaceKind::Hash;
    bool autoDisable = false;  // ODE's default thresholds: 0.01 m/s and rad/s for 10 steps
};

}  // namespace scenes
