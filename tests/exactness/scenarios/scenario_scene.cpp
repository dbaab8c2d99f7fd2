#include "scenario_scene.h"

#include <algorithm>

namespace exactness {

namespace {

ScenarioScene *livingScene = nullptr;

scenes::SceneOptions optionsFor(Stepper stepper, SpaceKind space) {
    scenes::SceneOptions options;
    options.stepper = stepper;
    options.space = space;
    return options;
}

// Colliders leave some numbers of a contact alone. They hold a pattern, so that writing to them shows.
dContact patternedContact() {
    dContact contact{};
    contact.geom.pos[3] = contact.geom.normal[3] = 1234.5;
    contact.geom.side1 = contact.geom.side2 = -77;
    return contact;
}

template <class Handle>
void forget(std::vector<Handle> &listed, Handle handle) {
    listed.erase(std::remove(listed.begin(), listed.end(), handle), listed.end());
}

bool isNested(dSpaceID space) { return dGeomGetSpace(reinterpret_cast<dGeomID>(space)) != nullptr; }

}  // namespace

ScenarioScene::ScenarioScene(Stepper stepper, SpaceKind space)
    : WorldScene(optionsFor(stepper, space), stepLength),
      m_stepper(stepper),
      m_group(dJointGroupCreate(0)),
      m_roots{this->space()} {
    livingScene = this;
}

// WorldScene destroys its own world and space. Spaces destroy their geoms, so those without go first.
ScenarioScene::~ScenarioScene() {
    dJointGroupDestroy(m_group);
    for (dGeomID geom : m_inventory.geoms) {
        if (dGeomGetSpace(geom) == nullptr) dGeomDestroy(geom);
    }
    for (dSpaceID root : m_roots) {
        if (root != space()) dSpaceDestroy(root);
    }
    for (dWorldID other : m_inventory.worlds) {
        if (other != world()) dWorldDestroy(other);
    }
    livingScene = nullptr;
}

void ScenarioScene::collide() {
    m_contacts = 0;
    for (dSpaceID root : m_roots) collideSpace(root);
}

void ScenarioScene::step() {
    for (dWorldID each : m_inventory.worlds) stepWorld(each);
}

void ScenarioScene::finish() {
    dJointGroupEmpty(m_group);
    m_contactFeedbacks.clear();
    m_time += m_stepSize;
    ++m_frame;
}

dWorldID ScenarioScene::addWorld() {
    const dWorldID added = dWorldCreate();
    dWorldSetGravity(added, 0, 0, -9.81);
    m_inventory.worlds.push_back(added);
    return added;
}

dSpaceID ScenarioScene::addSpace(dSpaceID added) {
    m_inventory.spaces.push_back(added);
    if (!isNested(added)) m_roots.push_back(added);
    return added;
}

dBodyID ScenarioScene::addBody(Vector3 position, dWorldID where) {
    const dBodyID body = add(dBodyCreate(where));
    dMass ball;
    dMassSetSphereTotal(&ball, 1, 0.2);
    dBodySetMass(body, &ball);
    dBodySetPosition(body, position.x, position.y, position.z);
    return body;
}

dBodyID ScenarioScene::carry(dGeomID geom, Vector3 position) {
    const dBodyID body = addBody(position, world());
    dGeomSetBody(geom, body);
    add(geom);
    return body;
}

// Upstream leaves the feedback of joints without rows unwritten, so it starts from known values.
dJointFeedback *ScenarioScene::addFeedback(dJointID joint) {
    m_feedbacks.push_back({});
    dJointSetFeedback(joint, &m_feedbacks.back());
    return &m_feedbacks.back();
}

void ScenarioScene::addContactFeedback(dJointID contact) {
    m_contactFeedbacks.push_back({});
    dJointSetFeedback(contact, &m_contactFeedbacks.back());
}

void ScenarioScene::destroy(dBodyID body) {
    while (dGeomID geom = dBodyGetFirstGeom(body)) destroy(geom);
    forget(m_inventory.bodies, body);
    dBodyDestroy(body);
}

void ScenarioScene::destroy(dJointID joint) {
    forget(m_inventory.joints, joint);
    dJointDestroy(joint);
}

void ScenarioScene::destroy(dGeomID geom) {
    forget(m_inventory.geoms, geom);
    dGeomDestroy(geom);
}

void ScenarioScene::onNearPair(dGeomID o1, dGeomID o2) {
    if (dGeomIsSpace(o1) || dGeomIsSpace(o2)) {
        collideTwo(o1, o2);
    } else {
        addContacts(o1, o2);
    }
}

void ScenarioScene::setSurface(dContact &contact) { contact.surface = m_surface; }

void ScenarioScene::stepWorld(dWorldID each) {
    if (m_stepper == Stepper::World) {
        dWorldStep(each, m_stepSize);
    } else {
        dWorldQuickStep(each, m_stepSize);
    }
}

void ScenarioScene::collideSpace(dSpaceID which) { dSpaceCollide(which, this, &nearCallback); }

void ScenarioScene::collideTwo(dGeomID one, dGeomID other) {
    dSpaceCollide2(one, other, this, &nearCallback);
}

void ScenarioScene::addContacts(dGeomID o1, dGeomID o2) {
    const dBodyID b1 = dGeomGetBody(o1), b2 = dGeomGetBody(o2);
    if (b1 == nullptr && b2 == nullptr) return;
    if (b1 != nullptr && b2 != nullptr && dAreConnectedExcluding(b1, b2, dJointTypeContact)) return;
    // Too many for a stack, perhaps; and callbacks may run on several threads.
    thread_local std::vector<dContact> contacts;
    contacts.assign(m_contactLimit, patternedContact());
    const int count = dCollide(o1, o2, m_contactLimit, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        setSurface(contacts[i]);
        onContact(addContact(contacts[i], dBodyGetWorld(b1 != nullptr ? b1 : b2)));
    }
}

dJointID ScenarioScene::addContact(dContact &contact, dWorldID where) {
    tell(contact);
    const dJointID joint = dJointCreateContact(where, m_group, &contact);
    dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    ++m_contacts;
    return joint;
}

void ScenarioScene::tell(const dContact &contact) {
    if (m_observer != nullptr) m_observer->contact(contact);
}

void ScenarioScene::watchMoved(dBodyID body) { dBodySetMovedCallback(body, &movedCallback); }

void ScenarioScene::note(const char *what, double value) {
    if (m_observer != nullptr) m_observer->note(what, value);
}

void ScenarioScene::noteContactFeedback() {
    for (const dJointFeedback &feedback : m_contactFeedbacks)
        for (const dReal *part : {feedback.f1, feedback.t1, feedback.f2, feedback.t2})
            for (int i = 0; i < 3; ++i) note("feedback of a contact", part[i]);
}

ScenarioScene &ScenarioScene::living() { return *livingScene; }

void ScenarioScene::nearCallback(void *scene, dGeomID o1, dGeomID o2) {
    auto *self = static_cast<ScenarioScene *>(scene);
    if (self->m_observer != nullptr) self->m_observer->nearPair(o1, o2);
    self->onNearPair(o1, o2);
}

void ScenarioScene::movedCallback(dBodyID body) {
    if (livingScene->m_observer != nullptr) livingScene->m_observer->bodyMoved(body);
    livingScene->onMoved(body);
}

void ManyParts::addParts(const std::function<void(int, Vector3)> &build, int count) {
    constexpr int columns = 4;
    constexpr dReal distance = 20;  // m
    for (int i = 0; i < count; ++i) build(i, {distance * (i % columns), distance * (i / columns), 0});
}

}  // namespace exactness
