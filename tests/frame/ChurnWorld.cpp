#include "ChurnWorld.h"

#include <cstring>

#include "world_parts.h"

ChurnWorld::ChurnWorld() : m_world(dWorldCreate()), m_space(dHashSpaceCreate(nullptr)), m_group(dJointGroupCreate(0)) {
    dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
    dCreatePlane(m_space, 0, 0, 1, 0);
    while (m_bodies.size() < kBodies) add();
}

ChurnWorld::~ChurnWorld() {
    dJointGroupDestroy(m_group);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

// Adds it on top of each group in order.
void ChurnWorld::add() {
    const unsigned group = m_made % kGroups, place = m_made / kGroups;
    const dBodyID body = dBodyCreate(m_world);
    dBodySetPosition(body, dReal(0.6) * group + dReal(0.03) * (place % 3), dReal(0.08) * (place % 2), dReal(0.06) + dReal(0.09) * (place % 6));
    dBodySetLinearVel(body, dReal(0.1) * (place % 4), dReal(-0.05) * (group % 3), 0);
    const dGeomID geom = m_made % 3 == 0 ? dCreateSphere(m_space, dReal(0.05)) : dCreateBox(m_space, dReal(0.1), dReal(0.1), dReal(0.1));
    dGeomSetBody(geom, body);
    m_bodies.push_back(body);
    ++m_made;
}

void ChurnWorld::change() {
    const auto chosen = [this](unsigned factor) { return (m_frame * factor + factor) % m_bodies.size(); };
    const std::size_t gone = chosen(7);
    dGeomDestroy(dBodyGetFirstGeom(m_bodies[gone]));
    dBodyDestroy(m_bodies[gone]);
    m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(gone));
    add();
    const dBodyID jumping = m_bodies[chosen(11)], pushed = m_bodies[chosen(13)], sleeping = m_bodies[chosen(5)];
    dBodySetPosition(jumping, dReal(0.6) * (m_frame % kGroups), dReal(0.1), dReal(0.5));
    dBodyAddForce(pushed, 5, 3, 10);
    dBodyDisable(sleeping);
}

void ChurnWorld::frames(int count) {
    for (; count > 0; --count, ++m_frame) {
        change();
        dSpaceCollide(m_space, this, [](void *data, dGeomID o1, dGeomID o2) {
            const ChurnWorld &world = *static_cast<ChurnWorld *>(data);
            dSurfaceParameters surface = {};
            surface.mu = dReal(0.7);
            joinWhereTheyTouch(world.m_world, world.m_group, surface, o1, o2);
        });
        (m_frame % 4 == 3 ? dWorldStep : dWorldQuickStep)(m_world, dReal(0.005));
        dJointGroupEmpty(m_group);
    }
}

std::uint64_t ChurnWorld::hash() const {
    std::vector<dReal> numbers;
    for (const dBodyID body : m_bodies) {
        appendMotion(numbers, body);
        numbers.push_back(dBodyIsEnabled(body));
    }
    numbers.push_back(static_cast<dReal>(dRandGetSeed()));
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto *const bytes = reinterpret_cast<const unsigned char *>(numbers.data());
    for (std::size_t i = 0; i < numbers.size() * sizeof(dReal); ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}
