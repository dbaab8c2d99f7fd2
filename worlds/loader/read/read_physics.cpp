#include "loader/read/read_physics.h"

#include "loader/read/element_path.h"
#include "loader/read/element_rules.h"
#include "loader/read/read_surface.h"

#include <sdf/Physics.hh>

#include <cmath>

namespace worlds {

namespace {

int wholeNumber(const Parameters &element, double number) {
    if (number != std::floor(number) || std::fabs(number) > 1e9) element.fail("is not a whole number");
    return static_cast<int>(number);
}

int wholeChild(const Parameters &element, const std::string &name, int otherwise) {
    const Parameters *child = element.child(name);
    return child ? wholeNumber(*child, child->number()) : otherwise;
}

ignition::math::Vector3d vectorChild(const Parameters &element, const std::string &name,
                                     const ignition::math::Vector3d &otherwise) {
    const Parameters *child = element.child(name);
    if (!child) return otherwise;
    const std::vector<double> numbers = child->numbers();
    if (numbers.size() != 3) child->fail("needs three numbers");
    return {numbers[0], numbers[1], numbers[2]};
}

scenes::Stepper readStepper(const Parameters &solver) {
    const Parameters *type = solver.child("type");
    if (!type || type->text == "quick") return scenes::Stepper::Quick;
    if (type->text == "world") return scenes::Stepper::World;
    type->fail("'" + type->text + "' is neither world nor quick");
}

bool readFrictionPyramid(const Parameters &solver) {
    const Parameters *model = solver.child("friction_model");
    if (!model || model->text == "pyramid_model") return true;
    if (model->text == "box_model") return false;
    model->fail("'" + model->text + "' is neither pyramid_model nor box_model");
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

Space readSpace(const Parameters &element) {
    element.expectOnly({"type"}, {"min_level", "max_level", "center", "extents", "depth"});
    Space space;
    const std::string &type = element.attribute("type");
    if (type == "simple")
        space.kind = scenes::SpaceKind::Simple;
    else if (type == "hash")
        space.kind = scenes::SpaceKind::Hash;
    else if (type == "sap")
        space.kind = scenes::SpaceKind::SweepAndPrune;
    else if (type == "quadtree")
        space.kind = scenes::SpaceKind::QuadTree;
    else
        element.fail("type '" + type + "' is none of simple, hash, sap, quadtree");
    space.minLevel = wholeChild(element, "min_level", space.minLevel);
    space.maxLevel = wholeChild(element, "max_level", space.maxLevel);
    space.center = vectorChild(element, "center", space.center);
    space.extents = vectorChild(element, "extents", space.extents);
    space.depth = wholeChild(element, "depth", space.depth);
    if (space.minLevel > space.maxLevel) element.fail("min_level is above max_level");
    if (space.extents.Min() <= 0) element.fail("extents are not positive");
    if (space.depth < 0 || space.depth > 10) element.fail("depth is not between 0 and 10");  // 4^depth cells
    return space;
}

double notNegative(const Parameters &element, const std::string &child, double otherwise) {
    const double number = element.childNumber(child, otherwise);
    if (number < 0) element.child(child)->fail("is negative");
    return number;
}

AutoDisable readAutoDisable(const Parameters &element) {
    element.expectOnly(
        {}, {"linear_threshold", "angular_threshold", "idle_time", "idle_steps", "average_samples"});
    AutoDisable rest;
    rest.linearThreshold = notNegative(element, "linear_threshold", rest.linearThreshold);
    rest.angularThreshold = notNegative(element, "angular_threshold", rest.angularThreshold);
    rest.idleTime = notNegative(element, "idle_time", rest.idleTime);
    rest.idleSteps = wholeChild(element, "idle_steps", rest.idleSteps);
    rest.averageSamples = wholeChild(element, "average_samples", rest.averageSamples);
    if (rest.averageSamples < 1) element.child("average_samples")->fail("is below 1");
    return rest;
}

double share(const Parameters &element, const std::string &child) {
    const double number = notNegative(element, child, 0);
    if (number > 1) element.child(child)->fail("is above 1");
    return number;
}

Damping readDamping(const Parameters &element) {
    element.expectOnly({}, {"linear", "angular", "linear_threshold", "angular_threshold"});
    Damping damping;
    damping.linear = share(element, "linear");
    damping.angular = share(element, "angular");
    damping.linearThreshold = notNegative(element, "linear_threshold", damping.linearThreshold);
    damping.angularThreshold = notNegative(element, "angular_threshold", damping.angularThreshold);
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
    if (physics.contactCandidates < 1 || physics.contactCandidates > 0xffff)  // dCollide counts in 16 bits
        element.child("odemt:contact_candidates")->fail("is not between 1 and 65535");
    return physics;
}

}  // namespace worlds
