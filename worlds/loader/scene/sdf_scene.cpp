#include "loader/scene/sdf_scene.h"

#include "loader/control/controller.h"
#include "loader/description/world_description.h"
#include "loader/scene/contact_rules.h"
#include "loader/scene/geom_factory.h"
#include "loader/scene/joint_axis.h"
#include "loader/scene/ode_joint.h"
#include "loader/scene/ode_world.h"
#include "support/text.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace worlds {

// Destroyed from the bottom up: contact joints, geoms, what geoms point to, the world with its bodies.
struct SdfScene::Parts {
    explicit Parts(const WorldDescription &description)
        : world(createWorld(description.physics)),
          rules(description),
          space(createSpace(description.physics.space)),
          contactGroup(dJointGroupCreate(0)),
          stepper(description.physics.stepper),
          springs(description.physics.stepSize),
          contactCandidates(static_cast<std::size_t>(description.physics.contactCandidates)) {}

    WorldOwner world;
    GeomFactory geoms;
    ContactRules rules;
    SpaceOwner space;
    JointGroupOwner contactGroup;
    scenes::Stepper stepper;
    JointSprings springs;
    std::size_t contactCandidates;  // of one pair

    std::vector<dBodyID> linkBodies;                     // by number of the link; null for static links
    std::unordered_map<std::string, JointMotor> motors;  // by joint, a second axis by "joint/axis2"
    std::unordered_map<std::string, dBodyID> bodies;     // by link
    std::vector<std::unique_ptr<dJointFeedback>> feedback;
    std::vector<std::unique_ptr<Controller>> controllers;
    long frame = 0;  // number of the coming one
};

SdfScene::SdfScene(const WorldDescription &world)
    : Scene(toReal(world.physics.stepSize)), m_parts(std::make_unique<Parts>(world)) {
    m_inventory.worlds.push_back(m_parts->world.get());
    m_inventory.spaces.push_back(m_parts->space.get());
    addLinks(world);
    setFrictionFrames(world);
    addJoints(world);
    addControllers(world);
}

SdfScene::~SdfScene() = default;

void SdfScene::addLinks(const WorldDescription &world) {
    const dSpaceID space = m_parts->space.get();
    for (const Link &link : world.links) {
        const dBodyID body = link.isStatic ? nullptr : createBody(m_parts->world.get(), link);
        m_parts->linkBodies.push_back(body);
        if (body) {
            m_inventory.bodies.push_back(body);
            m_bodyNames.push_back(link.name);
            m_parts->bodies.emplace(link.name, body);
        }
        for (const Collision &collision : link.collisions) {
            const dGeomID geom = withMemoryFor(collision.place, [&] {
                return body ? m_parts->geoms.createOn(body, space, collision, link.mass.center)
                            : m_parts->geoms.createStatic(space, collision, link.pose);
            });
            m_parts->rules.add(geom, link, collision);
            m_inventory.geoms.push_back(geom);
            m_geomNames.push_back(link.name + "::" + collision.name);
        }
    }
}

// The link may come later in the file than the shapes that name it.
void SdfScene::setFrictionFrames(const WorldDescription &world) {
    std::size_t geom = 0;
    for (const Link &link : world.links) {
        const std::string model = link.name.substr(0, link.name.rfind("::") + 2);
        for (const Collision &collision : link.collisions) {
            const dGeomID of = m_inventory.geoms[geom++];
            if (collision.surface.frictionFrame.empty()) continue;
            const std::string &name = collision.surface.frictionFrame;
            const auto found = std::find_if(world.links.begin(), world.links.end(),
                                            [&](const Link &other) { return other.name == model + name; });
            if (found == world.links.end())
                throw LoadError(LoadError::Kind::Value, collision.place, "model has no link " + support::quote(name));
            // A static link is turned for good: the direction of its shapes is not asked for otherwise.
            if (found->isStatic)
                throw LoadError(LoadError::Kind::Unsupported, collision.place, "fdir1 expressed in a static link");
            ContactRules::setFrictionFrame(of, m_parts->linkBodies[found - world.links.begin()]);
        }
    }
}

void SdfScene::addJoints(const WorldDescription &world) {
    const auto body = [&](int link) { return link == Joint::world ? nullptr : m_parts->linkBodies[link]; };
    for (const Joint &description : world.joints) {
        const dJointID joint =
            createJoint(m_parts->world.get(), description, body(description.parent), body(description.child));
        if (!joint) continue;
        m_inventory.joints.push_back(joint);
        m_jointNames.push_back(description.name);
        m_parts->springs.add(joint, description);
        for (std::size_t i = 0; i < description.axes.size(); ++i)
            m_parts->motors.emplace(
                i == 0 ? description.name : description.name + "/axis2",
                JointMotor(JointAxisHandle(joint, static_cast<int>(i)), description.axes[i]));
        if (description.feedback)
            dJointSetFeedback(joint,
                              m_parts->feedback.emplace_back(std::make_unique<dJointFeedback>()).get());
    }
}

void SdfScene::addControllers(const WorldDescription &world) {
    std::set<std::string> driven;  // a second controller would undo what the first one does
    std::set<dBodyID> pushed;      // drag of two, each of which stops the link, would turn its motion round
    for (const ControllerDescription &description : world.controllers) {
        const FindMotor findMotor = [&](const std::string &joint, const Element &namedBy) {
            const auto found = m_parts->motors.find(description.model + "::" + joint);
            if (found == m_parts->motors.end())
                namedBy.fail("model has no joint " + support::quote(joint) + " with an axis");
            if (!driven.insert(found->first).second)
                namedBy.fail("joint " + support::quote(joint) + " is driven already");
            return found->second;
        };
        const FindBody findBody = [&](const std::string &link, const Element &namedBy) {
            const auto found = m_parts->bodies.find(description.model + "::" + link);
            if (found == m_parts->bodies.end()) namedBy.fail("model has no link " + support::quote(link));
            if (!pushed.insert(found->second).second) namedBy.fail("link " + support::quote(link) + " is pushed already");
            return found->second;
        };
        m_parts->controllers.push_back(
            createController(description, findMotor, findBody, world.physics.stepSize));
    }
}

void SdfScene::control() {
    for (const std::unique_ptr<Controller> &controller : m_parts->controllers)
        controller->update(m_parts->frame);
    m_parts->springs.apply();
}

void SdfScene::collide() {
    m_contacts = 0;
    dSpaceCollide(m_parts->space.get(), this, &SdfScene::nearCallback);
}

void SdfScene::step() {
    if (m_parts->stepper == scenes::Stepper::World)
        dWorldStep(m_parts->world.get(), m_stepSize);
    else
        dWorldQuickStep(m_parts->world.get(), m_stepSize);
}

void SdfScene::finish() {
    dJointGroupEmpty(m_parts->contactGroup.get());
    ++m_parts->frame;
    m_time = static_cast<double>(m_parts->frame) * m_stepSize;
}

void SdfScene::nearCallback(void *scene, dGeomID geom1, dGeomID geom2) {
    static_cast<SdfScene *>(scene)->meet(geom1, geom2);
}

void SdfScene::meet(dGeomID geom1, dGeomID geom2) {
    if (m_observer) m_observer->nearPair(geom1, geom2);
    if (!ContactRules::mayTouch(geom1, geom2)) return;

    thread_local std::vector<dContact> contacts;  // callbacks may run on several threads
    contacts.resize(m_parts->contactCandidates);
    const int found =
        dCollide(geom1, geom2, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
    if (found == 0) return;
    const dSurfaceParameters surface = m_parts->rules.surface(geom1, geom2);
    for (const int i : deepestContacts(contacts, found, ContactRules::maxContacts(geom1, geom2))) {
        dContact &contact = contacts[i];
        contact.surface = surface;
        ContactRules::setDirection(contact);
        if (m_observer) m_observer->contact(contact);
        const dJointID joint =
            dJointCreateContact(m_parts->world.get(), m_parts->contactGroup.get(), &contact);
        dJointAttach(joint, dGeomGetBody(geom1), dGeomGetBody(geom2));
        ++m_contacts;
    }
}

}  // namespace worlds
