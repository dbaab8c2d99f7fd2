// Worlds written in a test, and ways to look into a scene.
#pragma once

#include "loader/description/geometry.h"
#include "loader/load_world.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace small_world {

using worlds::Vector3;

// A physics with a step of 1 ms and the full stepper, and ODE's own contact parameters.
extern const std::string physics;

// A floor at z = 0.
extern const std::string ground;

// <sdf><world>…</world></sdf> with `physics`; the worlds differ in what is inside.
std::string world(const std::string &inside);
std::string worldWith(const std::string &ownPhysics, const std::string &inside);

// A model of one link "link" with a mass of 1 kg, inertia 0.1 kg·m² about each axis, and one collision.
std::string model(const std::string &name, const std::string &pose, const std::string &geometry,
                  const std::string &surface = "");
std::string staticModel(const std::string &name, const std::string &pose, const std::string &geometry);
std::string linkOf1kg(const std::string &name, const std::string &pose, const std::string &inside = "");

std::string box(double x, double y, double z);
std::string sphere(double radius);

std::unique_ptr<worlds::SdfScene> load(const std::string &sdf, const worlds::LoadOptions &options = {});

struct Loaded {
    std::unique_ptr<worlds::SdfScene> scene;
    std::vector<std::string> warnings;
};
Loaded loadWithWarnings(const std::string &sdf, bool ignoreUnsupported = false);

// Return objects by the names of the scene; a test failure and an exception if there is none.
dBodyID body(const worlds::SdfScene &scene, const std::string &name);
dJointID joint(const worlds::SdfScene &scene, const std::string &name);
dGeomID geom(const worlds::SdfScene &scene, const std::string &name);

dMass massOf(dBodyID body);
Vector3 position(dBodyID body);
Vector3 velocity(dBodyID body);
Vector3 spin(dBodyID body);

void run(worlds::SdfScene &scene, int frames);
void runFor(worlds::SdfScene &scene, double seconds);

// No body is at a place or speed that is not a number.
bool isFinite(const worlds::SdfScene &scene);

std::size_t staticGeoms(const worlds::SdfScene &scene);
double totalMass(const worlds::SdfScene &scene, const std::string &model);

// Loading fails in this way, and the message holds all of `parts`.
void expectError(const std::string &sdf, worlds::LoadError::Kind kind, const std::vector<std::string> &parts);

}  // namespace small_world
