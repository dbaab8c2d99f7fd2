#include "PackedWorld.h"

#include "world_parts.h"

namespace {

constexpr dReal kEdge = dReal(0.1), kPitch = dReal(0.098);  // m: neighbours overlap

}  // namespace

PackedWorld::PackedWorld(int columns, int rows, int layers, dWorldStepFunction *stepper)
    : m_world(dWorldCreate()),
      m_space(dHashSpaceCreate(nullptr)),
      m_group(dJointGroupCreate(0)),
      m_stepper(stepper) {
    dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
    dCreatePlane(m_space, 0, 0, 1, 0);
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                addBox(kPitch * x + dReal(0.03) * (z % 2), kPitch * y, kEdge / 2 + kPitch * z);
}

PackedWorld::~PackedWorld() {
    dJointGroupDestroy(m_group);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

void PackedWorld::addBox(dReal x, dReal y, dReal z) {
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetBoxTotal(&mass, 1 + x, kEdge, kEdge, kEdge);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    dBodySetLinearVel(body, y, -x, 0);
    dGeomSetBody(dCreateBox(m_space, kEdge, kEdge, kEdge), body);
    m_bodies.push_back(body);
}

void PackedWorld::frame() {
    dSpaceCollide(m_space, this, [](void *world, dGeomID o1, dGeomID o2) {
        static_cast<PackedWorld *>(world)->makeContacts(o1, o2);
    });
    m_stepper(m_world, dReal(0.005));
    dJointGroupEmpty(m_group);
}

void PackedWorld::makeContacts(dGeomID o1, dGeomID o2) {
    dSurfaceParameters surface = {};
    surface.mode = dContactApprox1;
    surface.mu = dReal(0.6);
    joinWhereTheyTouch(m_world, m_group, surface, o1, o2);
}

std::vector<dReal> PackedWorld::state() const {
    std::vector<dReal> numbers;
    for (const dBodyID body : m_bodies) appendMotion(numbers, body);
    return numbers;
}
