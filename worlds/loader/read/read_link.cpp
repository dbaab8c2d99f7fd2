#include "loader/read/read_link.h"

#include "loader/read/read_shape.h"
#include "loader/read/read_surface.h"
#include "loader/read/semantic_pose.h"

#include <sdf/Collision.hh>

namespace worlds {

namespace {

// Returns a flag of a link: model and link may both have it, and the link's takes precedence.
bool flag(const sdf::ElementPtr &element, const std::string &name, bool otherwise) {
    return element->HasElement(name) ? element->Get<bool>(name) : otherwise;
}

Mass readMass(const sdf::Link &link, const Place &place) {
    const ignition::math::Inertiald &inertial = link.Inertial();
    // Along the link's axes, whatever the rotation of the inertial frame.
    const Mass mass{inertial.MassMatrix().Mass(), inertial.Pose().Pos(), inertial.Moi()};
    if (!inertial.MassMatrix().IsPositive())
        throw LoadError(LoadError::Kind::Value, place, "the inertia matrix is not positive definite");
    return mass;
}

void readDamping(const sdf::ElementPtr &element, Link &link) {
    if (!element->HasElement("velocity_decay")) return;
    const sdf::ElementPtr decay = element->GetElement("velocity_decay");
    if (decay->HasElement("linear")) link.linearDamping = decay->Get<double>("linear");
    if (decay->HasElement("angular")) link.angularDamping = decay->Get<double>("angular");
}

std::optional<Collision> readCollision(const sdf::Collision &source, bool isStatic, const Reading &reading) {
    const sdf::ElementPtr element = source.Element();
    Collision collision;
    collision.name = source.Name();
    collision.place = reading.place(element);
    std::optional<Shape> shape =
        withMemoryFor(collision.place, [&] { return readShape(*source.Geom(), isStatic, reading); });
    if (!shape) return std::nullopt;
    collision.shape = std::move(*shape);
    collision.pose = resolvePose(source.SemanticPose(), collision.place);
    collision.pose.Pos() += collision.pose.Rot() * shapeOffset(*source.Geom());
    collision.surface = reading.physics.defaultSurface;
    if (element->HasElement("surface"))
        collision.surface = readSurface(toParameters(element->GetElement("surface"), reading.worldFile),
                                        collision.surface, reading.physics.stepSize);
    collision.maxContacts =
        element->HasElement("max_contacts") ? element->Get<int>("max_contacts") : reading.physics.maxContacts;
    return collision;
}

}  // namespace

Link readLink(const sdf::Link &source, const sdf::Model &model, const std::string &name,
              const ignition::math::Pose3d &modelPose, bool isStatic, const Reading &reading) {
    const sdf::ElementPtr element = source.Element();
    const Place place = reading.place(element);
    Link link;
    link.name = name;
    link.pose = modelPose * resolvePose(source.SemanticPose(), place);
    link.isStatic = isStatic;
    link.kinematic = flag(element, "kinematic", false);
    link.gravity = flag(element, "gravity", true);
    link.selfCollide = flag(element, "self_collide", model.SelfCollide());
    link.autoDisable = model.AllowAutoDisable();
    link.mass = readMass(source, place);
    readDamping(element, link);
    for (uint64_t i = 0; i < source.CollisionCount(); ++i)
        if (std::optional<Collision> collision =
                readCollision(*source.CollisionByIndex(i), isStatic, reading))
            link.collisions.push_back(std::move(*collision));
    return link;
}

}  // namespace worlds
