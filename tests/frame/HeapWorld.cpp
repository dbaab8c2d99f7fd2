#include "HeapWorld.h"

#include "world_parts.h"

HeapWorld::HeapWorld(dSpaceID space) : m_world(dWorldCreate()), m_space(space), m_group(dJointGroupCreate(0)) {
    dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
    dCreatePlane(m_space, 0, 0, 1, 0);
    constexpr dReal kPitch = 0.102;
    for (int layer = 0; layer < 2; ++layer)
        for (int i = 0; i < kSide * kSide; ++i)
            add(kPitch * (i % kSide) + dReal(0.01) * layer, kPitch * (i / kSide), dReal(0.06) + kPitch * layer,
                (i + layer) % 3 == 0);
}

HeapWorld::~HeapWorld() {
    dJointGroupDestroy(m_group);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

void HeapWorld::add(dReal x, dReal y, dReal z, bool ball) {
    const dBodyID body = dBodyCreate(m_world);
    dBodySetPosition(body, x, y, z);
    const dGeomID geom = ball ? dCreateSphere(m_space, dReal(0.05)) : dCreateBox(m_space, dReal(0.1), dReal(0.1), dReal(0.1));
    dGeomSetBody(geom, body);
    m_bodies.push_back(body);
}

void HeapWorld::collide() {
    dSpaceCollide(m_space, this, [](void *data, dGeomID o1, dGeomID o2) {
        HeapWorld &world = *static_cast<HeapWorld *>(data);
        if (world.m_callback != nullptr)
            world.m_callback(world, o1, o2);
        else
            world.makeContacts(o1, o2);
    });
}

void HeapWorld::makeContacts(dGeomID o1, dGeomID o2) {
    dSurfaceParameters surface = {};
    surface.mu = dReal(0.7);
    m_contacts += joinWhereTheyTouch(m_world, m_group, surface, o1, o2);
}

void HeapWorld::step() {
    dWorldQuickStep(m_world, dReal(0.005));
    dJointGroupEmpty(m_group);
}

std::vector<dReal> HeapWorld::positions() const {
    std::vector<dReal> numbers;
    for (const dBodyID body : m_bodies) append(numbers, dBodyGetPosition(body), 3);
    return numbers;
}
