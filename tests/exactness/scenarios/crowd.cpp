#include "crowd.h"

#include <cstdint>

namespace exactness {

namespace {

constexpr int bodiesOneIn = 3, familySize = 12;
constexpr std::intptr_t noContacts = -1;  // in place of a family

std::intptr_t familyOf(dGeomID geom) { return reinterpret_cast<std::intptr_t>(dGeomGetData(geom)); }

bool mayTouch(dGeomID o1, dGeomID o2) {
    const std::intptr_t one = familyOf(o1), other = familyOf(o2);
    if (one == noContacts || other == noContacts) return false;
    return dGeomGetBody(o1) == nullptr || dGeomGetBody(o2) == nullptr || one == other;
}

}  // namespace

Crowd::Crowd(Stepper stepper, SpaceKind kind, unsigned seed) : ScenarioScene(stepper, kind), m_dice(seed) {
    dWorldSetGravity(world(), 0, 0, 0);
    dWorldSetContactMaxCorrectingVel(world(), 1);
    dWorldSetAngularDamping(world(), 0.05);
    dWorldSetLinearDamping(world(), 0.01);
    m_contactLimit = 2;
}

dGeomID Crowd::addMember(Vector3 place, dReal size) {
    if (m_turns % bodiesOneIn != 0) return addMemberWithoutBody(place, size);
    const dGeomID geom = createByTurns(size);
    const dBodyID body = carry(geom, place);
    const Vector3 velocity = m_dice.within(4 * size);
    dBodySetLinearVel(body, velocity.x, velocity.y, velocity.z);
    dBodySetAngularVel(body, m_dice.between(-1, 1), m_dice.between(-1, 1), m_dice.between(-1, 1));
    return geom;
}

dGeomID Crowd::addMemberWithoutBody(Vector3 place, dReal size) {
    const dGeomID geom = add(createByTurns(size));
    dGeomSetPosition(geom, place.x, place.y, place.z);
    dQuaternion turn;
    dQFromAxisAndAngle(turn, m_dice.between(-1, 1), m_dice.between(-1, 1), 1, m_dice.between(0, 3));
    dGeomSetQuaternion(geom, turn);
    dGeomSetCollideBits(geom, ~0ul);  // members without bodies collide with one another too
    return geom;
}

void Crowd::addMembers(int count, dReal halfEdge, dReal size) {
    for (int i = 0; i < count; ++i) addMember(m_dice.within(halfEdge), size * m_dice.between(0.5, 1));
}

void Crowd::keepFromContacts(dGeomID geom) { dGeomSetData(geom, reinterpret_cast<void *>(noContacts)); }

dGeomID Crowd::createByTurns(dReal size) {
    const int turn = m_turns++;
    dGeomID geom = nullptr;
    switch (turn % 4) {
        case 0:
            geom = dCreateSphere(space(), size / 2);
            break;
        case 1:
            geom = dCreateBox(space(), size, size * 0.7, size * 0.4);
            break;
        case 2:
            geom = dCreateCapsule(space(), size * 0.2, size * 0.6);
            break;
        default:
            geom = dCreateCylinder(space(), size * 0.3, size * 0.8);
            break;
    }
    dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(turn / familySize)));
    return geom;
}

void Crowd::moveEvery(int nth) {
    const auto moves = [nth](std::size_t number) {
        return nth > 0 && number % static_cast<std::size_t>(nth) == 0;
    };
    for (std::size_t i = 0; i < m_inventory.bodies.size(); ++i) {
        if (moves(i)) {
            dBodyEnable(m_inventory.bodies[i]);
        } else {
            dBodyDisable(m_inventory.bodies[i]);
        }
    }
    for (std::size_t i = 0; i < m_inventory.geoms.size(); ++i) {
        if (moves(i)) nudge(m_inventory.geoms[i]);
    }
}

void Crowd::alternate() {
    constexpr int phases[] = {1, 1, 0, 0, 89, 61, 1, 0, 7, 0, 1, 2};
    constexpr int count = sizeof(phases) / sizeof(phases[0]);
    moveEvery(phases[frameNumber() % count]);
}

void Crowd::nudge(dGeomID geom) {
    if (dGeomGetClass(geom) == dPlaneClass || dGeomGetBody(geom) != nullptr) return;
    const dReal *place = dGeomGetPosition(geom);
    const Vector3 push = m_dice.within(0.05);
    dGeomSetPosition(geom, place[0] + push.x, place[1] + push.y, place[2] + push.z);
}

void Crowd::onNearPair(dGeomID o1, dGeomID o2) {
    if (dGeomIsSpace(o1) || dGeomIsSpace(o2) || mayTouch(o1, o2)) ScenarioScene::onNearPair(o1, o2);
}

}  // namespace exactness
