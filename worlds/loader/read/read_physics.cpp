#include "loader/read/read_physics.h"

#include "loader/read/element_path.h"
#include "loader/read/element_rules.h"
#include "loader/read/read_surface.h"

#include <sdf/Physics.hh>

#include <cmath>

namespace worlds {

namespace {

// element_rules.h has checked what is read here: types, ranges and names.

int wholeChild(const Parameters &element, const std::string &name, int otherwise) {
    const Parameters *child = element.child(name);
    return child ? static_cast<int>(child->number()) : otherwise;
}

ignition::math::Vector3d vectorChild(const Parameters &element, const std::string &name,
                                     const ignition::math::Vector3d &otherwise) {
    const Parameters *child = element.child(name);
    if (!child) return otherwise;
    const std::vector<double> numbers = child->numbers();
    return {numbers[0], numbers[1], numbers[2]};
}

scenes::Stepper readStepper(const Parameters &solver) {
    const Parameters *type = solver.child("type");
    return type && type->text == "world" ? scenes::Stepper::World : scenes::Stepper::Quick;
}

bool readFrictionPyramid(const Parameters &solver) {
    const Parameters *model = solver.child("friction_model");
    return !model || model->text == "pyramid_model";
}

void readOde(const Parameters &ode, Physics &physics) {
    if (const Parameters *solver = ode.child("solver")) {
        physics.stepper = readStepper(*solver);
        physics.frictionPyramid = readFrictionPyramid(*solver);
        physics.iterations = wholeChild(*solver, "iters", physics.iterations);
        physics.sor = solver->childNumber("sor", physics.sor);
    }
    if (const Parameters *constraints = ode.child("constraints")) {
        physics.cfm = constraints->childNumber("cfm", physics.cfm);
        physics.erp = constraints->childNumber("erp", physics.erp);
        physics.maxCorrectingSpeed =
            constraints->childLimit("contact_max_correcting_vel", physics.maxCorrectingSpeed);
        if (physics.maxCorrectingSpeed >= largestNumber) physics.maxCorrectingSpeed = INFINITY;
        physics.surfaceLayer = constraints->childNumber("contact_surface_layer", physics.surfaceLayer);
    }
}

// What other kinds of spaces have would do nothing here.
void refuseOfOthers(const Parameters &element, const std::string &type) {
    static const struct {
        const char *child, *type;
    } kOf[] = {{"min_level", "hash"},
               {"max_level", "hash"},
               {"center", "quadtree"},
               {"extents", "quadtree"},
               {"depth", "quadtree"}};
    for (const auto &of : kOf)
        if (const Parameters *child = element.child(of.child); child && type != of.type)
            child->fail("is for spaces of type " + std::string(of.type) + " alone");
}

Space readSpace(const Parameters &element) {
    Space space;
    const std::string &type = element.attribute("type");
    if (type == "hash") space.kind = scenes::SpaceKind::Hash;
    if (type == "sap") space.kind = scenes::SpaceKind::SweepAndPrune;
    if (type == "quadtree") space.kind = scenes::SpaceKind::QuadTree;
    refuseOfOthers(element, type);
    space.minLevel = wholeChild(element, "min_level", space.minLevel);
    space.maxLevel = wholeChild(element, "max_level", space.maxLevel);
    space.center = vectorChild(element, "center", space.center);
    space.extents = vectorChild(element, "extents", space.extents);
    space.depth = wholeChild(element, "depth", space.depth);
    if (space.minLevel > space.maxLevel) element.fail("min_level is above max_level");
    return space;
}

AutoDisable readAutoDisable(const Parameters &element) {
    AutoDisable rest;
    rest.linearThreshold = element.childNumber("linear_threshold", rest.linearThreshold);
    rest.angularThreshold = element.childNumber("angular_threshold", rest.angularThreshold);
    rest.idleTime = element.childNumber("idle_time", rest.idleTime);
    rest.idleSteps = wholeChild(element, "idle_steps", rest.idleSteps);
    rest.averageSamples = wholeChild(element, "average_samples", rest.averageSamples);
    return rest;
}

Damping readDamping(const Parameters &element) {
    Damping damping;
    damping.linear = element.childNumber("linear", 0);
    damping.angular = element.childNumber("angular", 0);
    damping.linearThreshold = element.childNumber("linear_threshold", damping.linearThreshold);
    damping.angularThreshold = element.childNumber("angular_threshold", damping.angularThreshold);
    return damping;
}

}  // namespace

Physics readPhysics(const sdf::World &world, const std::string &worldFile) {
    Physics physics;
    physics.gravity = world.Gravity();
    const sdf::Physics *profile = world.PhysicsDefault();
    if (!profile || !profile->Element()) return physics;

    const Parameters element = toParameters(profile->Element(), worldFile);
    physics.stepSize = element.childNumber("max_step_size", physics.stepSize);
    physics.maxContacts = wholeChild(element, "max_contacts", physics.maxContacts);
    if (const Parameters *ode = element.child("ode")) readOde(*ode, physics);
    if (const Parameters *surface = element.child("odemt:default_surface"))
        physics.defaultSurface = readSurface(*surface, {}, physics.stepSize);
    if (const Parameters *space = element.child("odemt:space")) physics.space = readSpace(*space);
    if (const Parameters *rest = element.child("odemt:auto_disable"))
        physics.autoDisable = readAutoDisable(*rest);
    if (const Parameters *damping = element.child("odemt:damping")) physics.damping = readDamping(*damping);
    physics.contactCandidates = wholeChild(element, "odemt:contact_candidates", physics.contactCandidates);
    return physics;
}

}  // namespace worlds
