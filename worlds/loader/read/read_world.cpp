#include "loader/read/read_world.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "loader/control/controller.h"
#include "loader/read/element_rules.h"
#include "loader/read/frames.h"
#include "loader/read/read_collision.h"
#include "loader/read/read_joint.h"
#include "loader/read/shape_mass.h"

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

namespace {

// What the links of a model share.
struct Model {
    std::string name;  // "outer::inner"
    int number = 0;
    bool isStatic = false, selfCollide = false, autoDisable = true;
};

// A body has no other moments: one is at most the sum of the other two. That is so when half their sum less the
// matrix is positive, but for rounding.
bool isOfABody(const Matrix3 &inertia) {
    const double half = (inertia(0, 0) + inertia(1, 1) + inertia(2, 2)) / 2;
    Matrix3 spread;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) spread(i, j) = (i == j ? half * (1 + 1e-9) : 0) - inertia(i, j);
    return isPositiveDefinite(spread);
}

// Along the link's axes, whatever the rotation of the inertial frame.
Mass readMass(const Element &link, bool isStatic, const Issues &issues) {
    Mass mass;
    const Element *const inertial = link.child("inertial"), *const inertia = inertial
                                                                                 ? inertial->child("inertia")
                                                                                 : nullptr;
    const auto moment = [&](const char *name, double otherwise) {
        return inertia ? inertia->childNumber(name, otherwise) : otherwise;
    };
    Matrix3 &own = mass.inertia;
    own(0, 0) = moment("ixx", 1);
    own(1, 1) = moment("iyy", 1);
    own(2, 2) = moment("izz", 1);
    own(0, 1) = own(1, 0) = moment("ixy", 0);
    own(0, 2) = own(2, 0) = moment("ixz", 0);
    own(1, 2) = own(2, 1) = moment("iyz", 0);
    if (!inertial) return mass;
    mass.mass = inertial->childNumber("mass", 1);
    const Pose pose = readPose(inertial->child("pose"));
    mass.center = pose.position;
    if (!isStatic && !isPositiveDefinite(own)) inertia->fail("the inertia matrix is not positive definite");
    if (!isStatic && !isOfABody(own))
        issues.warn(inertia->place(), "no body has such an inertia matrix: a moment is above the sum of the others");
    const Matrix3 turn = Matrix3::rotation(pose.rotation);
    own = turn * own * turn.transposed();
    return mass;
}

// Whether the mass is to be that of the link's shapes.
bool isMassOfShapes(const Element &link) {
    const Element *const inertial = link.child("inertial");
    return inertial && isTrue(inertial->attributeOrEmpty("auto"));
}

class WorldReader {
public:
    WorldReader(WorldDescription &world, const std::shared_ptr<Element> &document, const Reading &reading)
        : m_world(world), m_document(document), m_reading(reading) {}

    // Reads the models of a world, or in a model. `outer` is "outer::" for a model within a model.
    void models(Element &element, const Scope &scope, const std::string &outer, const Pose &pose,
                bool isStatic) {
        for (Element &child : element.children) {
            if (child.name != "model" || child.isMerged) continue;
            Model model;
            model.name = outer + child.attribute("name");
            model.number = m_modelCount++;
            model.isStatic = isStatic || child.childFlag("static", false);
            model.selfCollide = child.childFlag("self_collide", false);
            model.autoDisable = child.childFlag("allow_auto_disable", true);
            this->model(child, scope.inside(child), model, pose * scope.pose(child));
        }
    }

private:
    // `element` is the model's own, or that of one that is merged into it.
    void model(Element &element, const Scope &scope, const Model &model, const Pose &pose) {
        for (Element &child : element.children) {
            if (child.name == "link") link(child, scope, model, pose);
            if (child.isMerged) this->model(child, scope.inside(child), model, pose * scope.pose(child));
        }
        models(element, scope, model.name + "::", pose, model.isStatic);
        for (Element &child : element.children) {
            if (child.name == "joint") joint(child, scope, model, pose);
            if (child.name == "plugin") controller(child, model);
        }
    }

    void link(const Element &element, const Scope &scope, const Model &model, const Pose &modelPose) {
        Link link;
        link.name = model.name + "::" + element.attribute("name");
        link.model = numberOf(link.name, model);
        link.pose = modelPose * scope.pose(element);
        link.isStatic = model.isStatic;
        link.kinematic = element.childFlag("kinematic", false);
        link.gravity = element.childFlag("gravity", true);
        link.selfCollide = element.childFlag("self_collide", model.selfCollide);
        link.autoDisable = model.autoDisable;
        if (const Element *const decay = element.child("velocity_decay")) {
            if (const Element *const linear = decay->child("linear")) link.linearDamping = linear->number();
            if (const Element *const angular = decay->child("angular"))
                link.angularDamping = angular->number();
        }
        const bool isOfShapes = !model.isStatic && isMassOfShapes(element);
        ShapeMass shapes;
        for (const Element &child : element.children)
            if (child.name == "collision" && collision(child, element, scope, link) && isOfShapes)
                shapes.add(link.collisions.back(), density(child, element));
        link.mass = isOfShapes ? massOf(element, shapes) : readMass(element, model.isStatic, m_reading.issues);
        m_numbers[&element] = static_cast<int>(m_world.links.size());
        m_world.links.push_back(std::move(link));
    }

    // The link's own, where a shape has none; else water's.
    static double density(const Element &collision, const Element &link) {
        constexpr double kWater = 1000;  // kg/m³
        const Element *const inertial = link.child("inertial");
        return collision.childNumber("density", inertial ? inertial->childNumber("density", kWater) : kWater);
    }

    // A mass that is written scales that of the shapes, as since libsdformat 15.2.
    Mass massOf(const Element &link, const ShapeMass &shapes) const {
        const Element &inertial = link.required("inertial");
        const std::optional<Mass> total = shapes.total();
        if (!total) {
            m_reading.issues.unsupported(inertial.place(),
                                         "auto=\"true\" without a collision that has a volume, or beyond what can be computed with");
            return readMass(link, false, m_reading.issues);
        }
        const Element *const mass = inertial.child("mass");
        return mass ? scaledTo(mass->number(), *total) : *total;
    }

    // Old versions write a model within a model as links "inner::link".
    int numberOf(const std::string &link, const Model &model) {
        const std::string inner = link.substr(0, link.rfind("::"));
        if (inner == model.name) return model.number;
        const auto [known, isNew] = m_innerNumbers.emplace(inner, m_modelCount);
        if (isNew) ++m_modelCount;
        return known->second;
    }

    // Returns whether there is one.
    bool collision(const Element &element, const Element &link, const Scope &scope, Link &read) {
        const Element *const pose = element.child("pose");
        const std::string frame = pose ? pose->attributeOrEmpty("relative_to") : std::string();
        Pose inLink = readPose(pose);
        if (!frame.empty())
            inLink = scope.pose(link).inverse() * scope.pose(frame, *pose, "relative_to") * inLink;
        std::optional<Collision> collision = readCollision(element, inLink, read.isStatic, m_world.physics, m_reading);
        if (collision) read.collisions.push_back(std::move(*collision));
        return collision.has_value();
    }

    void joint(const Element &element, const Scope &scope, const Model &model, const Pose &modelPose) {
        const JointedBodies bodies = readJointedBodies(element, scope);
        if (model.isStatic) return;  // nothing for it to move
        Joint joint =
            readJoint(element, scope, model.name + "::" + element.attribute("name"), modelPose, m_reading);
        joint.parent = bodies.parent ? m_numbers.at(bodies.parent) : Joint::world;
        joint.child = m_numbers.at(bodies.child);
        m_world.joints.push_back(std::move(joint));
    }

    void controller(Element &element, const Model &model) {
        if (model.isStatic) return;  // nothing for it to move
        element.limitNumbers(kMaxControllerNumber);
        m_world.controllers.push_back({element.attribute("filename"), model.name,
                                       std::shared_ptr<const Element>(m_document, &element)});
    }

    WorldDescription &m_world;
    const std::shared_ptr<Element> &m_document;
    const Reading &m_reading;
    std::unordered_map<const Element *, int> m_numbers;  // of links
    std::unordered_map<std::string, int> m_innerNumbers;
    int m_modelCount = 0;
};

}  // namespace

WorldDescription readWorld(const std::shared_ptr<Element> &document, const Reading &reading) {
    Element &element = document->children.front();  // the world
    WorldDescription world;
    world.physics = readPhysics(element);
    const Scope scope(element);
    scope.resolve();
    WorldReader(world, document, reading).models(element, scope, "", {}, false);
    return world;
}

}  // namespace worlds
