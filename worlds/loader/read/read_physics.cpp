#include "loader/read/read_physics.h"

#include "loader/read/element_rules.h"
#include "loader/read/read_collision.h"

#include <cmath>

namespace worlds {

namespace {

// element_rules.h has checked what is read here: types, ranges and names.

int wholeChild(const Element &element, const std::string &name, int otherwise) {
    const Element *child = element.child(name);
    return child ? static_cast<int>(child->number()) : otherwise;
}

scenes::Stepper readStepper(const Element &solver) {
    const Element *type = solver.child("type");
    return type && type->text == "world" ? scenes::Stepper::World : scenes::Stepper::Quick;
}

bool readFrictionPyramid(const Element &solver) {
    const Element *model = solver.child("friction_model");
    return !model || model->text == "pyramid_model";
}

void readOde(const Element &ode, Physics &physics) {
    if (const Element *solver = ode.child("solver")) {
        physics.stepper = readStepper(*solver);
        physics.frictionPyramid = readFrictionPyramid(*solver);
        physics.iterations = wholeChild(*solver, "iters", physics.iterations);
        physics.sor = solver->childNumber("sor", physics.sor);
        physics.stepSize = solver->childNumber("dt", physics.stepSize);  // where old versions have it
    }
    if (const Element *constraints = ode.child("constraints")) {
        physics.cfm = constraints->childNumber("cfm", physics.cfm);
        physics.erp = constraints->childNumber("erp", physics.erp);
        physics.maxCorrectingSpeed =
            constraints->childLimit("contact_max_correcting_vel", physics.maxCorrectingSpeed);
        if (physics.maxCorrectingSpeed >= largestNumber) physics.maxCorrectingSpeed = INFINITY;
        physics.surfaceLayer = constraints->childNumber("contact_surface_layer", physics.surfaceLayer);
    }
}

// What other kinds of spaces have would do nothing here.
void refuseOfOthers(const Element &element, const std::string &type) {
    static const struct {
        const char *child, *type;
    } kOf[] = {{"min_level", "hash"},
               {"max_level", "hash"},
               {"center", "quadtree"},
               {"extents", "quadtree"},
               {"depth", "quadtree"}};
    for (const auto &of : kOf)
        if (const Element *child = element.child(of.child); child && type != of.type)
            child->fail("is for spaces of type " + std::string(of.type) + " alone");
}

Space readSpace(const Element &element) {
    Space space;
    const std::string &type = element.attribute("type");
    if (type == "hash") space.kind = scenes::SpaceKind::Hash;
    if (type == "sap") space.kind = scenes::SpaceKind::SweepAndPrune;
    if (type == "quadtree") space.kind = scenes::SpaceKind::QuadTree;
    refuseOfOthers(element, type);
    space.minLevel = wholeChild(element, "min_level", space.minLevel);
    space.maxLevel = wholeChild(element, "max_level", space.maxLevel);
    space.center = element.childVector("center", space.center);
    space.extents = element.childVector("extents", space.extents);
    space.depth = wholeChild(element, "depth", space.depth);
    if (space.minLevel > space.maxLevel) element.fail("min_level is above max_level");
    return space;
}

AutoDisable readAutoDisable(const Element &element) {
    AutoDisable rest;
    rest.linearThreshold = element.childNumber("linear_threshold", rest.linearThreshold);
    rest.angularThreshold = element.childNumber("angular_threshold", rest.angularThreshold);
    rest.idleTime = element.childNumber("idle_time", rest.idleTime);
    rest.idleSteps = wholeChild(element, "idle_steps", rest.idleSteps);
    rest.averageSamples = wholeChild(element, "average_samples", rest.averageSamples);
    return rest;
}

Damping readDamping(const Element &element) {
    Damping damping;
    damping.linear = element.childNumber("linear", 0);
    damping.angular = element.childNumber("angular", 0);
    damping.linearThreshold = element.childNumber("linear_threshold", damping.linearThreshold);
    damping.angularThreshold = element.childNumber("angular_threshold", damping.angularThreshold);
    return damping;
}

// Several engines' may be there: the default one counts, or the first.
const Element *profileOf(const Element &world) {
    const Element *chosen = world.child("physics");
    for (const Element &child : world.children)
        if (child.name == "physics" && isTrue(child.attributeOrEmpty("default"))) chosen = &child;
    return chosen;
}

}  // namespace

Physics readPhysics(const Element &world) {
    Physics physics;
    physics.gravity = world.childVector("gravity", physics.gravity);
    const Element *profile = profileOf(world);
    if (!profile) return physics;

    const Element &element = *profile;
    physics.gravity = element.childVector("gravity", physics.gravity);  // where old versions have it
    physics.maxContacts = wholeChild(element, "max_contacts", physics.maxContacts);
    if (const Element *ode = element.child("ode")) readOde(*ode, physics);
    physics.stepSize = element.childNumber("max_step_size", physics.stepSize);
    if (const Element *surface = element.child("odemt:default_surface"))
        physics.defaultSurface = readSurface(*surface, {}, physics.stepSize);
    if (const Element *space = element.child("odemt:space")) physics.space = readSpace(*space);
    if (const Element *rest = element.child("odemt:auto_disable"))
        physics.autoDisable = readAutoDisable(*rest);
    if (const Element *damping = element.child("odemt:damping")) physics.damping = readDamping(*damping);
    physics.contactCandidates = wholeChild(element, "odemt:contact_candidates", physics.contactCandidates);
    return physics;
}

}  // namespace worlds
