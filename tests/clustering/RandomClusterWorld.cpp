#include "RandomClusterWorld.h"

#include <cmath>

namespace {

void gatherBodies(dGeomID geom, std::set<dBodyID> &bodies) {
    if (const dBodyID body = dGeomGetBody(geom)) bodies.insert(body);
    if (!dGeomIsSpace(geom)) return;
    const dSpaceID space = reinterpret_cast<dSpaceID>(geom);
    for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) gatherBodies(dSpaceGetGeom(space, i), bodies);
}

bool isPlaceable(dGeomID geom) { return !dGeomIsSpace(geom) && dGeomGetClass(geom) != dPlaneClass; }

}  // namespace

RandomClusterWorld::RandomClusterWorld(unsigned seed, bool hash)
    : m_random(seed), m_world(dWorldCreate()), m_space(hash ? dHashSpaceCreate(nullptr) : dSimpleSpaceCreate(nullptr)) {
    for (int i = 4 + below(25); i > 0; --i) make();
}

RandomClusterWorld::~RandomClusterWorld() {
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

std::vector<ReferenceInhabitant> RandomClusterWorld::inhabitants() const {
    std::vector<ReferenceInhabitant> all;
    for (std::size_t i = 0; i < m_geoms.size(); ++i) {
        dReal aabb[6];
        dGeomGetAABB(m_geoms[i], aabb);
        all.push_back({m_ids[i], false, dxBounds(aabb), {}});
        gatherBodies(m_geoms[i], all.back().bodies);
        all.back().isDynamic = !all.back().bodies.empty();
    }
    return all;
}

void RandomClusterWorld::add(dGeomID geom) {
    dSpaceAdd(m_space, geom);
    m_geoms.push_back(geom);
    m_ids.push_back(m_nextId++);
}

void RandomClusterWorld::place(dGeomID geom) {
    if (!isPlaceable(geom)) return;
    const dReal reach = chance(0.03) ? m_extent * 100 : m_extent;
    dGeomSetPosition(geom, uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach) / 2);
}

dGeomID RandomClusterWorld::makeShape() {
    const dGeomID geom = chance(0.5) ? dCreateSphere(nullptr, size() / 2) : dCreateBox(nullptr, size(), size(), size());
    place(geom);
    return geom;
}

void RandomClusterWorld::make() {
    if (chance(0.04)) return add(dCreatePlane(nullptr, below(2), 0, 1, uniform(-1, 1) * m_extent));
    if (chance(0.04)) return add(dCreateBox(nullptr, m_extent * 4, m_extent * 3, 1));  // a floor, or a ship
    if (chance(0.1)) return makeRobot();
    if (chance(0.1)) return makeNested();
    if (chance(0.15)) {
        const dGeomID wall = dCreateBox(nullptr, uniform(5, 30), dReal(0.3), 2);
        place(wall);
        return add(wall);
    }
    const dGeomID geom = makeShape();
    if (chance(0.6)) {
        const dBodyID shared = !m_geoms.empty() && chance(0.1) ? dGeomGetBody(m_geoms[below(m_geoms.size())]) : nullptr;
        dGeomSetBody(geom, shared != nullptr ? shared : dBodyCreate(m_world));
        place(geom);
    }
    add(geom);
}

void RandomClusterWorld::makeRobot() {
    dBodyID previous = nullptr;
    for (int i = 2 + below(3); i > 0; --i) {
        const dBodyID body = dBodyCreate(m_world);
        for (int k = 1 + below(2); k > 0; --k) {
            const dGeomID geom = makeShape();
            dGeomSetBody(geom, body);
            dGeomSetOffsetPosition(geom, uniform(-2, 2), uniform(-2, 2), 0);
            add(geom);
        }
        dBodySetPosition(body, uniform(-m_extent, m_extent), uniform(-m_extent, m_extent), 0);
        if (previous != nullptr) {
            m_joints.push_back(dJointCreateBall(m_world, nullptr));
            dJointAttach(m_joints.back(), previous, body);
        }
        previous = body;
    }
}

void RandomClusterWorld::makeNested() {
    const dSpaceID outer = dSimpleSpaceCreate(nullptr), inner = dHashSpaceCreate(outer);
    const dReal x = uniform(-m_extent, m_extent), y = uniform(-m_extent, m_extent);
    for (int i = 1 + below(3); i >= 0; --i) {
        const dGeomID geom = makeShape();
        dGeomSetPosition(geom, x + uniform(-2, 2), y + uniform(-2, 2), 0);
        dSpaceAdd(chance(0.5) ? inner : outer, geom);
        if (chance(0.4)) dGeomSetBody(geom, dBodyCreate(m_world));
        if (dGeomGetBody(geom) != nullptr) dGeomSetPosition(geom, x, y, uniform(-2, 2));
    }
    add(reinterpret_cast<dGeomID>(outer));
}

void RandomClusterWorld::changeJoint() {
    if (!m_joints.empty() && chance(0.6)) {
        std::swap(m_joints[below(m_joints.size())], m_joints.back());
        dJointDestroy(m_joints.back());
        m_joints.pop_back();
        return;
    }
    const dBodyID a = dGeomGetBody(m_geoms[below(m_geoms.size())]), b = dGeomGetBody(m_geoms[below(m_geoms.size())]);
    if (a == b || a == nullptr || b == nullptr) return;
    m_joints.push_back(dJointCreateHinge(m_world, nullptr));
    dJointAttach(m_joints.back(), a, b);
}

// To the space it is another geom.
void RandomClusterWorld::leaveAndComeBack(std::size_t i) {
    const dGeomID geom = m_geoms[i];
    if (!isPlaceable(geom)) return;
    place(geom);
    dSpaceRemove(m_space, geom);
    dSpaceAdd(m_space, geom);
    m_ids[i] = m_nextId++;
}

void RandomClusterWorld::changeOne() {
    const std::size_t i = below(m_geoms.size());
    const dGeomID geom = m_geoms[i];
    switch (below(12)) {
    case 0: make(); break;
    case 1:
        if (m_geoms.size() < 4) break;
        dGeomDestroy(geom);
        m_geoms.erase(m_geoms.begin() + static_cast<std::ptrdiff_t>(i));
        m_ids.erase(m_ids.begin() + static_cast<std::ptrdiff_t>(i));
        break;
    case 2:
        if (!isPlaceable(geom)) break;
        dGeomSetBody(geom, nullptr);  // upstream fails an assertion where a geom with an offset changes its body
        if (chance(0.5)) dGeomSetBody(geom, dBodyCreate(m_world));
        if (dGeomGetBody(geom) != nullptr) place(geom);
        break;
    case 3: changeJoint(); break;
    case 4:
        if (dGeomGetClass(geom) == dSphereClass) dGeomSphereSetRadius(geom, size());
        break;
    case 5: leaveAndComeBack(i); break;
    case 6:
        if (dGeomIsSpace(geom) && dSpaceGetNumGeoms(reinterpret_cast<dSpaceID>(geom)) > 0) {
            const dGeomID inner = dSpaceGetGeom(reinterpret_cast<dSpaceID>(geom), 0);
            if (!dGeomIsSpace(inner)) dGeomSetBody(inner, chance(0.5) ? nullptr : dBodyCreate(m_world));
        }
        break;
    case 7: place(geom); break;
    default:  // a step
        if (!isPlaceable(geom)) break;
        const dReal *const p = dGeomGetPosition(geom);
        dGeomSetPosition(geom, p[0] + uniform(-3, 3), p[1] + uniform(-3, 3), p[2] + uniform(-1, 1));
    }
}

void RandomClusterWorld::change() {
    if (chance(0.02)) m_extent *= chance(0.5) ? 3 : dReal(0.3);
    for (int i = 1 + below(8); i > 0; --i) changeOne();
    // At least this one.
    const dGeomID geom = m_geoms.front();
    if (isPlaceable(geom)) place(geom);
    else add(makeShape());
}
