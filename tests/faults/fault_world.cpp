#include "fault_world.h"

#include <cstring>
#include <new>

namespace faults {

namespace {

constexpr int kInTower = 4;
constexpr int kLinks = 6;
constexpr int kMaxContacts = 4;
constexpr int kSamples = 5;

dSpaceID createSpace(SpaceKind kind) {
    switch (kind) {
        case SpaceKind::simple:
            return dSimpleSpaceCreate(nullptr);
        case SpaceKind::hash:
            return dHashSpaceCreate(nullptr);
        case SpaceKind::sweepAndPrune:
            return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
        case SpaceKind::quadTree: {
            const dVector3 centre{0, 0, 0}, extents{40, 40, 40};
            return dQuadTreeSpaceCreate(nullptr, centre, extents, 4);
        }
    }
    return nullptr;
}

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 29;
}

std::uint64_t mix(std::uint64_t hash, const dReal *values, int count) {
    for (int i = 0; i < count; ++i) {
        std::uint64_t word = 0;
        std::memcpy(&word, values + i, sizeof values[i]);
        hash = mix(hash, word);
    }
    return hash;
}

std::uint64_t numberOf(dGeomID geom) { return reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)); }

// The arrays of the geoms that have some; such a geom keeps the address.
const dReal *convexPlanes() {
    static const dReal planes[] = {1, 0,  0, 0.3, -1, 0, 0, 0.3, 0, 1, 0,  0.3,
                                   0, -1, 0, 0.3, 0,  0, 1, 0.3, 0, 0, -1, 0.3};
    return planes;
}
const dReal *convexPoints() {
    static const dReal points[] = {0.3, 0.3, 0.3,  -0.3, 0.3, 0.3,  0.3, -0.3, 0.3,  -0.3, -0.3, 0.3,
                                   0.3, 0.3, -0.3, -0.3, 0.3, -0.3, 0.3, -0.3, -0.3, -0.3, -0.3, -0.3};
    return points;
}
const unsigned *convexPolygons() {
    static const unsigned polygons[] = {4, 0, 2, 6, 4, 4, 1, 5, 7, 3, 4, 0, 4, 5, 1,
                                        4, 2, 3, 7, 6, 4, 0, 1, 3, 2, 4, 4, 6, 7, 5};
    return polygons;
}

}  // namespace

FaultWorld::FaultWorld(SpaceKind kind, Stepper stepper, int towers, bool towersTouch)
    : m_stepper(stepper),
      m_world(dWorldCreate()),
      m_space(createSpace(kind)),
      m_contacts(dJointGroupCreate(0)) {
    dWorldSetGravity(m_world, 0, 0, -9.81);
    dGeomSetData(dCreatePlane(m_space, 0, 0, 1, 0), reinterpret_cast<void *>(1));
    m_guest = dCreateSphere(m_space, 0.2);
    addClasses();
    addChain();
    addTowers(towers, towersTouch ? 0.59 : 1.0);
}

FaultWorld::~FaultWorld() {
    dJointGroupDestroy(m_contacts);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
    dGeomTriMeshDataDestroy(m_mesh);
    dGeomHeightfieldDataDestroy(m_terrain);
}

dBodyID FaultWorld::addBody(dGeomID geom, dReal x, dReal y, dReal z) {
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetSphereTotal(&mass, 1, 0.3);
    dBodySetMass(body, &mass);
    dGeomSetBody(geom, body);
    dBodySetPosition(body, x, y, z);
    m_bodies.push_back(body);
    dGeomSetData(geom, reinterpret_cast<void *>(m_bodies.size() + 100));
    return body;
}

void FaultWorld::addTowers(int towers, dReal pitch) {
    for (int tower = 0; tower < towers; ++tower)
        for (int level = 0; level < kInTower; ++level)
            addBody(dCreateSphere(m_space, 0.3), 2.0 + pitch * (tower % 16), 2.0 + pitch * (tower / 16), 0.29 + 0.59 * level);
}

// A geom of each class stands on a terrain, one more hangs over it; a mesh lies on its own.
void FaultWorld::addClasses() {
    static const float vertices[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 0, 0.4f};
    static const dTriIndex indices[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    m_mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(m_mesh, vertices, 3 * sizeof(float), 5, indices, 12, 3 * sizeof(dTriIndex));
    static const dReal heights[kSamples * kSamples] = {0, 1, 0, 1, 0, 1, 2, 1, 2, 1, 0, 1, 0,
                                                       1, 0, 1, 2, 1, 2, 1, 0, 1, 0, 1, 0};
    m_terrain = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(m_terrain, heights, 1, 8, 8, kSamples, kSamples, 0.1, 0, 0.5, 0);
    const dGeomID terrain = dCreateHeightfield(m_space, m_terrain, 1);
    dMatrix3 upright;
    dRFromAxisAndAngle(upright, 1, 0, 0, M_PI / 2);
    dGeomSetRotation(terrain, upright);
    dGeomSetPosition(terrain, -8, -8, 0.2);
    dGeomSetData(terrain, reinterpret_cast<void *>(2));
    const dGeomID mesh = dCreateTriMesh(m_space, m_mesh, nullptr, nullptr, nullptr);
    dGeomSetPosition(mesh, -3, 3, 0);
    dGeomSetData(mesh, reinterpret_cast<void *>(3));
    for (int over = 0; over < 2; ++over) {
        const dReal x = over == 0 ? -9 : -3.3, y = over == 0 ? -8 : 3, z = over == 0 ? 0.8 : 0.7;
        addBody(dCreateSphere(m_space, 0.3), x, y, z);
        addBody(dCreateBox(m_space, 0.5, 0.5, 0.5), x + 0.4, y + 0.1, z + 0.05);
        addBody(dCreateCapsule(m_space, 0.2, 0.4), x, y + 0.5, z + 0.1);
        addBody(dCreateCylinder(m_space, 0.2, 0.4), x + 0.5, y + 0.5, z);
        addBody(dCreateConvex(m_space, convexPlanes(), 6, convexPoints(), 8, convexPolygons()), x + 0.2,
                y + 0.2, z + 0.6);
    }
    const dSpaceID nested = dSimpleSpaceCreate(m_space);
    addBody(dCreateBox(nested, 0.4, 0.4, 0.4), -3, -3, 0.19);
    addBody(dCreateBox(nested, 0.4, 0.4, 0.4), -3, -3, 0.58);
}

void FaultWorld::addChain() {
    m_feedbacks.resize(kLinks);
    dBodyID last = nullptr;
    for (int link = 0; link < kLinks; ++link) {
        const dBodyID body = addBody(dCreateSphere(m_space, 0.1), 0, 0.3 * link, 1.5);
        const dJointID hinge = dJointCreateHinge(m_world, nullptr);
        dJointAttach(hinge, body, last);
        dJointSetHingeAnchor(hinge, 0, 0.3 * link, 1.5);
        dJointSetHingeAxis(hinge, 1, 0, 0);
        dJointSetFeedback(hinge, &m_feedbacks[link]);
        last = body;
    }
}

bool FaultWorld::attempt(int part) {
    m_isRefused = false;
    try {
        return tryPart(part) && !m_isRefused;
    } catch (const std::bad_alloc &) {
        return false;
    }
}

bool FaultWorld::tryPart(int part) {
    if (part == 0) {
        change();
    } else if (part == 1) {
        dSpaceCollide(m_space, this, nearCallback);
    } else {
        if (m_stepper(m_world, 0.01) == 0) return false;
        dJointGroupEmpty(m_contacts);
        ++m_frames;
    }
    return true;
}

void FaultWorld::takeBack(int part) {
    if (part != 1) return;
    dJointGroupEmpty(m_contacts);
    m_pairs = 0;
}

// Each of these may be done twice: a program whose call was refused makes it again.
void FaultWorld::change() {
    m_pairs = 0;
    const std::size_t turn = static_cast<std::size_t>(m_frames);
    const dBodyID body = m_bodies[5 * turn % m_bodies.size()],
                  other = m_bodies[(7 * turn + 3) % m_bodies.size()];
    dBodySetPosition(body, dBodyGetPosition(body)[0], dBodyGetPosition(body)[1],
                     1.0 + 0.125 * (m_frames % 8));
    dGeomSetCategoryBits(dBodyGetFirstGeom(other), m_frames % 2 == 0 ? 3ul : ~0ul);
    if (m_guest != nullptr) dGeomDestroy(m_guest);
    m_guest = nullptr;
    m_guest = dCreateSphere(m_space, 0.2);
    dGeomSetPosition(m_guest, 2.1, 2, 0.3);
    dGeomSetData(m_guest, reinterpret_cast<void *>(4));
}

std::uint64_t FaultWorld::hash() const {
    std::uint64_t hash = mix(m_pairs.load(), dRandGetSeed());
    for (const dBodyID body : m_bodies) {
        hash = mix(hash, dBodyGetPosition(body), 3);
        hash = mix(hash, dBodyGetQuaternion(body), 4);
        hash = mix(hash, dBodyGetLinearVel(body), 3);
        hash = mix(hash, dBodyGetAngularVel(body), 3);
    }
    for (const dJointFeedback &feedback : m_feedbacks) hash = mix(hash, feedback.f1, 3);
    return hash;
}

void FaultWorld::useSpace() {
    const dGeomID geom = dCreateBox(m_space, 1, 1, 1);
    dSpaceRemove(m_space, geom);
    dGeomDestroy(geom);
}

// Lets no exception pass: the space would stay locked, as upstream's does.
void FaultWorld::nearCallback(void *world, dGeomID a, dGeomID b) {
    FaultWorld &self = *static_cast<FaultWorld *>(world);
    try {
        self.meet(a, b);
    } catch (const std::bad_alloc &) {
        self.m_isRefused = true;
    }
}

void FaultWorld::meet(dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        dSpaceCollide2(a, b, this, nearCallback);
        return;
    }
    dContact contacts[kMaxContacts];
    std::memset(contacts, 0, sizeof contacts);
    const int count = dCollide(a, b, kMaxContacts, &contacts[0].geom, sizeof contacts[0]);
    m_pairs.fetch_add(mix(mix(numberOf(a), numberOf(b)), static_cast<std::uint64_t>(count)));
    if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mode = dContactBounce;
        contacts[i].surface.mu = 0.5;
        contacts[i].surface.bounce = 0.1;
        dJointAttach(dJointCreateContact(m_world, m_contacts, contacts + i), dGeomGetBody(a),
                     dGeomGetBody(b));
    }
}

}  // namespace faults
