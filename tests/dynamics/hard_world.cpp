#include "hard_world.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr dReal kSpacing = 20;  // between scenes
constexpr int kMaxContacts = 8;

struct Collision {
    dWorldID world;
    dJointGroupID contacts;
};

void addContacts(void *data, dGeomID one, dGeomID other) {
    const Collision &collision = *static_cast<Collision *>(data);
    dContact contacts[kMaxContacts]{};
    const int count = dCollide(one, other, kMaxContacts, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mu = dInfinity;
        const dJointID joint = dJointCreateContact(collision.world, collision.contacts, &contacts[i]);
        dJointAttach(joint, dGeomGetBody(one), dGeomGetBody(other));
    }
}

}  // namespace

HardWorld::HardWorld(unsigned seed, const Shape &shape)
    : m_random(seed), m_shape(shape), m_world(dWorldCreate()), m_space(dHashSpaceCreate(nullptr)), m_contacts(dJointGroupCreate(0)) {
    dWorldSetCFM(m_world, 0);
    dWorldSetERP(m_world, between(0.2, 0.8));
    dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
    dCreatePlane(m_space, 0, 0, 1, 0);
    m_massRange = chance(2) ? 0 : 4;
}

HardWorld::~HardWorld() {
    dJointGroupDestroy(m_contacts);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

void HardWorld::add(Scene scene) {
    const dReal y = m_nextY;
    m_nextY += kSpacing;
    switch (scene) {
        case Scene::DoubleHinges: return addChain(y);
        case Scene::Linkage: return addLinkage(y);
        case Scene::Tower: return addTower(y);
        case Scene::FixedJoints: return addFixedJoints(y);
    }
}

void HardWorld::collide() {
    dJointGroupEmpty(m_contacts);
    Collision collision{m_world, m_contacts};
    dSpaceCollide(m_space, &collision, &addContacts);
}

std::vector<dReal> HardWorld::state() const {
    std::vector<dReal> all;
    for (const dBodyID body : m_bodies) {
        all.insert(all.end(), dBodyGetPosition(body), dBodyGetPosition(body) + 3);
        all.insert(all.end(), dBodyGetQuaternion(body), dBodyGetQuaternion(body) + 4);
        all.insert(all.end(), dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
        all.insert(all.end(), dBodyGetAngularVel(body), dBodyGetAngularVel(body) + 3);
    }
    return all;
}

dReal HardWorld::drawMass() { return std::pow(dReal(10), between(-m_massRange / 2, m_massRange / 2)); }

dBodyID HardWorld::addBox(dReal x, dReal y, dReal z, dReal sizeX, dReal sizeY, dReal sizeZ, bool isSolid) {
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetBoxTotal(&mass, drawMass(), sizeX, sizeY, sizeZ);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    if (isSolid) dGeomSetBody(dCreateBox(m_space, sizeX, sizeY, sizeZ), body);
    m_bodies.push_back(body);
    return body;
}

// About the y-axis.
dJointID HardWorld::addHinge(dBodyID one, dBodyID other, dReal x, dReal y, dReal z) {
    const dJointID joint = dJointCreateHinge(m_world, nullptr);
    dJointAttach(joint, one, other);
    dJointSetHingeAnchor(joint, x, y, z);
    dJointSetHingeAxis(joint, 0, 1, 0);
    return joint;
}

// A motor or stops, or none. Stops may be where the bodies are not, and motors may be stronger than these.
void HardWorld::limit(dJointID hinge) {
    if (chance(2)) {
        dJointSetHingeParam(hinge, dParamVel, between(-5, 5));
        dJointSetHingeParam(hinge, dParamFMax, chance(2) ? dReal(1e5) : between(0, 100));  // infinite ones push bodies infinitely at stops
    }
    if (m_shape.isContradictory && chance(3)) {
        const dReal stop = between(-1, 1);
        dJointSetHingeParam(hinge, dParamLoStop, stop);
        dJointSetHingeParam(hinge, dParamHiStop, stop + (chance(2) ? 0 : dReal(0.1)));
    }
}

// In the air. Where hinges contradict one another, the second one of a pair lies aside, or about another axis, or has other stops.
void HardWorld::addChain(dReal y) {
    const unsigned links = 1 + m_random() % m_shape.maxLinks;
    const bool isHanging = !chance(4), hasAnchorsApart = m_shape.isContradictory && chance(2), hasOtherAxes = m_shape.isContradictory && chance(4);
    const bool hasStops = m_shape.hasLimits && chance(3);
    dBodyID last = nullptr;
    for (unsigned i = 0; i < links; ++i) {
        const dBodyID link = addBox(dReal(i), y, 80, dReal(0.9), dReal(0.2), dReal(0.1), false);
        const dReal x = dReal(i) - dReal(0.5);
        for (unsigned k = 0; k < 2 && (last != nullptr || isHanging); ++k) {
            const dJointID joint = addHinge(link, last, x, y, 80);
            if (hasStops) limit(joint);
            if (k == 0) continue;
            if (hasAnchorsApart) dJointSetHingeAnchor(joint, x + between(-0.3, 0.3), y, 80 + between(-0.1, 0.1));
            if (hasOtherAxes) dJointSetHingeAxis(joint, between(-1, 1), 1, between(-1, 1));
        }
        last = link;
    }
}

// Four bars in a plane: hinges about parallel axes leave three rows too many.
void HardWorld::addLinkage(dReal y) {
    const unsigned bars = 3 + m_random() % 6;
    const dReal radius = dReal(bars) / 5, centre = 80;
    std::vector<dBodyID> ring;
    const auto corner = [&](unsigned i) { return 2 * dReal(M_PI) * dReal(i) / dReal(bars); };
    for (unsigned i = 0; i < bars; ++i) {
        const dReal angle = (corner(i) + corner(i + 1)) / 2;
        ring.push_back(addBox(radius * std::cos(angle), y, centre + radius * std::sin(angle), dReal(0.2), dReal(0.2), dReal(0.2), false));
    }
    for (unsigned i = 0; i < bars; ++i) {
        const bool isGround = i == 0;  // its first end is held by the world as well
        const dReal x = radius * std::cos(corner(i)), z = centre + radius * std::sin(corner(i));
        const dJointID joint = addHinge(ring[i], ring[(i + bars - 1) % bars], x, y, z);
        if (isGround) addHinge(ring[0], nullptr, x, y, z);
        limit(joint);
    }
}

// Boxes on one another, some with weights far above them.
void HardWorld::addTower(dReal y) {
    const unsigned boxes = 1 + m_random() % 8;
    const dReal depth = between(0, 0.02);
    for (unsigned i = 0; i < boxes; ++i)
        addBox(between(-0.1, 0.1), y + between(-0.1, 0.1), dReal(0.5) + (1 - depth) * dReal(i) - depth, 1, 1, 1, true);
}

// A few bodies, each fixed to others more than once; they have moved between two joints if these are to contradict one another.
void HardWorld::addFixedJoints(dReal y) {
    const std::size_t first = m_bodies.size();
    const unsigned count = 2 + m_random() % 8, joints = count + m_random() % (2 * count);
    for (unsigned i = 0; i < count; ++i) addBox(dReal(i), y, 80, dReal(0.5), dReal(0.5), dReal(0.5), false);
    for (unsigned i = 0; i < joints; ++i) {
        const dBodyID one = m_bodies[first + m_random() % count], other = m_bodies[first + m_random() % count];
        const dJointID joint = dJointCreateFixed(m_world, nullptr);
        dJointAttach(joint, one, one == other || chance(6) ? nullptr : other);
        dJointSetFixed(joint);
        if (!m_shape.isContradictory || !chance(3)) continue;
        const dReal *const at = dBodyGetPosition(one);
        dBodySetPosition(one, at[0] + between(-0.1, 0.1), at[1], at[2] + between(-0.1, 0.1));
    }
}
