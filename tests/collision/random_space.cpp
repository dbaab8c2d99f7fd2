#include "random_space.h"

#include <cmath>

namespace collision {

namespace {

int numberOf(dGeomID geom) { return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); }

}  // namespace

RandomSpace::RandomSpace(const Recipe &recipe) : m_random(recipe.seed), m_breath(recipe.breathes ? recipe.geoms / 5 : 0) {
    m_world = dWorldCreate();
    m_space = recipe.hash ? dHashSpaceCreate(nullptr) : dSimpleSpaceCreate(nullptr);
    if (recipe.hash && chance(0.5)) {
        const int lowest = below(12) - 8;
        dHashSpaceSetLevels(m_space, lowest, lowest + below(10));
    }
    m_smallest = uniform(-3, 1);
    m_largest = m_smallest + (chance(0.3) ? 6 : uniform(0, 2));
    m_extent = std::pow(dReal(10), (m_smallest + m_largest) / 2) * std::cbrt(dReal(recipe.geoms)) * uniform(dReal(0.3), 2);
    // Far below the origin the hash space's cell addresses wrap, and it loses pairs.
    dSetZero(m_centre, 4);
    if (chance(0.5))
        for (int axis = 0; axis < 3; ++axis) m_centre[axis] = uniform(-1, 1) * m_extent * (chance(0.5) ? 2 : 400);
    if (chance(0.3)) m_centre[0] = m_centre[1] = m_extent;
    for (int i = 0; i < recipe.geoms; ++i) m_geoms.push_back(make());
}

RandomSpace::~RandomSpace() {
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

dGeomID RandomSpace::make() {
    dGeomID geom = chance(0.05) ? reinterpret_cast<dGeomID>(makeSubspace()) : makeShape();
    dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(m_nextNumber++)));
    dSpaceAdd(m_space, geom);
    return geom;
}

dGeomID RandomSpace::makeShape() {
    if (chance(0.03)) return dCreatePlane(nullptr, below(2), below(2), 1, uniform(-1, 1) * m_extent);
    dGeomID geom;
    switch (below(4)) {
    case 0: geom = dCreateSphere(nullptr, size()); break;
    case 1: geom = dCreateBox(nullptr, size(), size(), size()); break;
    case 2: geom = dCreateCapsule(nullptr, size(), size()); break;
    default: geom = dCreateRay(nullptr, size() * 5); break;
    }
    if (chance(0.7)) {
        dBodyID body = !m_geoms.empty() && chance(0.1) ? dGeomGetBody(m_geoms.back()) : nullptr;
        dGeomSetBody(geom, body != nullptr ? body : dBodyCreate(m_world));
    }
    place(geom);
    if (chance(0.3)) dGeomSetCategoryBits(geom, 1u + below(7));
    if (chance(0.3)) dGeomSetCollideBits(geom, 1u + below(7));
    return geom;
}

dSpaceID RandomSpace::makeSubspace() {
    dSpaceID space = chance(0.5) ? dSimpleSpaceCreate(nullptr) : dHashSpaceCreate(nullptr);
    for (int i = below(4); i >= 0; --i) {
        dGeomID sphere = dCreateSphere(space, size());
        dGeomSetData(sphere, reinterpret_cast<void *>(static_cast<std::intptr_t>(-1)));
        place(sphere);
    }
    return space;
}

void RandomSpace::place(dGeomID geom) {
    if (dGeomIsSpace(geom) || dGeomGetClass(geom) == dPlaneClass) return;
    dVector3 position;
    for (int axis = 0; axis < 3; ++axis) position[axis] = m_centre[axis] + uniform(-m_extent, m_extent);
    dGeomSetPosition(geom, position[0], position[1], position[2]);
}

void RandomSpace::breathe(int frame) {
    const bool grows = frame % 10 < 5;
    for (int i = 0; i < m_breath; ++i) {
        if (grows) {
            m_geoms.push_back(make());
        } else {
            std::swap(m_geoms[below(static_cast<int>(m_geoms.size()))], m_geoms.back());
            dGeomDestroy(m_geoms.back());
            m_geoms.pop_back();
        }
    }
}

void RandomSpace::changeSomething(int frame) {
    breathe(frame);
    const bool quiet = chance(0.2);
    const int changes = quiet ? 0 : below(static_cast<int>(m_geoms.size()) + 1) / (chance(0.5) ? 10 : 1);
    for (int i = 0; i < changes; ++i) change(m_geoms[below(static_cast<int>(m_geoms.size()))]);
    m_togglesLeft = chance(0.3) ? 3 : 0;
}

void RandomSpace::change(dGeomID &geom) {
    switch (below(10)) {
    case 0: place(geom); break;
    case 1: {
        const dGeomID old = geom;
        geom = make();
        dGeomDestroy(old);
        break;
    }
    case 2:
        // Only a geom that has just moved: upstream fails an assertion where one that is clean is added before
        // others have been cleaned.
        place(geom);
        if (dGeomIsSpace(geom) || dGeomGetClass(geom) == dPlaneClass) break;
        dSpaceRemove(m_space, geom);
        dSpaceAdd(m_space, geom);
        break;
    case 3: dGeomSetCategoryBits(geom, 1u + below(7)); break;
    case 4: dGeomSetCollideBits(geom, ~0u); break;
    case 5: chance(0.5) ? dGeomEnable(geom) : dGeomDisable(geom); break;
    case 6:
        if (!dGeomIsSpace(geom) && dGeomGetClass(geom) != dPlaneClass) dGeomSetBody(geom, nullptr);
        break;
    case 7:
        if (dGeomGetClass(geom) == dSphereClass) dGeomSphereSetRadius(geom, size());
        break;
    default:  // a small step
        if (dGeomIsSpace(geom) || dGeomGetClass(geom) == dPlaneClass) break;
        const dReal *const position = dGeomGetPosition(geom);
        const dReal step = m_extent / 100;
        dGeomSetPosition(geom, position[0] + uniform(-step, step), position[1] + uniform(-step, step), position[2]);
    }
}

std::vector<std::pair<int, int>> RandomSpace::collide() {
    m_met.clear();
    dSpaceCollide(m_space, this, met);
    return m_met;
}

void RandomSpace::met(void *self, dGeomID a, dGeomID b) {
    RandomSpace &space = *static_cast<RandomSpace *>(self);
    space.m_met.emplace_back(numberOf(a), numberOf(b));
    if (space.m_togglesLeft == 0 || !space.chance(0.1)) return;
    --space.m_togglesLeft;
    dGeomID geom = space.chance(0.5) ? a : space.m_geoms[space.below(static_cast<int>(space.m_geoms.size()))];
    dGeomIsEnabled(geom) ? dGeomDisable(geom) : dGeomEnable(geom);
}

std::vector<int> RandomSpace::list() const {
    std::vector<int> numbers;
    for (int i = 0; i < dSpaceGetNumGeoms(m_space); ++i) numbers.push_back(numberOf(dSpaceGetGeom(m_space, i)));
    return numbers;
}

}  // namespace collision
