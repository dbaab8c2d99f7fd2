// Parameters of the world as a whole. SDF's defaults are the initial values here.
#pragma once

#include "loader/description/geometry.h"
#include "loader/description/surface.h"
#include "scenes/scene_options.h"

#include <optional>

namespace worlds {

// A body at rest for `idleTime` and `idleSteps` is no longer simulated until something touches it.
struct AutoDisable {
    double linearThreshold = 0.01;   // m/s
    double angularThreshold = 0.01;  // rad/s
    double idleTime = 0;             // s
    int idleSteps = 10;
    int averageSamples = 1;
};

// Share of a body's speed that ODE takes away at every step, above a threshold.
struct Damping {
    double linear = 0, angular = 0;
    double linearThreshold = 0, angularThreshold = 0;  // m/s, rad/s
};

struct Space {
    scenes::SpaceKind kind = scenes::SpaceKind::Simple;
    int minLevel = -3, maxLevel = 10;                         // hash: cells of 2^level m
    Vector3 center, extents{100, 100, 100};  // quadtree, m
    int depth = 5;                                            // quadtree
};

struct Physics {
    double stepSize = 0.001;  // s
    Vector3 gravity{0, 0, -9.8};
    scenes::Stepper stepper = scenes::Stepper::Quick;
    int iterations = 50;  // of the quick stepper
    double sor = 1.3;     // its over-relaxation
    double cfm = 0, erp = 0.2;
    double maxCorrectingSpeed = 100;  // m/s, of contacts
    double surfaceLayer = 0.001;      // m, depth at which contacts rest
    bool frictionPyramid = true;      // friction follows the normal force; false: a constant box

    int maxContacts = 20;         // contact joints for one pair of shapes; the deepest are kept
    int contactCandidates = 100;  // contacts asked of ODE for one pair

    Space space;
    Surface defaultSurface;
    std::optional<AutoDisable> autoDisable;  // unset: bodies never sleep
    std::optional<Damping> damping;
};

}  // namespace worlds
