#include "random_space.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

int numberOf(dGeomID geom) { return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); }

RandomSpace *asked = nullptr;  // the space that collides

}  // namespace

RandomSpace::RandomSpace(const Recipe &recipe)
    : m_random(recipe.seed), m_kind(recipe.kind), m_isCrowd(recipe.geoms > 300),
      m_breath(recipe.breathes ? recipe.geoms / 5 : 0) {
    if (m_kind != Kind::Hash) {
        dGeomClass oddities{};
        oddities.bytes = 6 * sizeof(dReal);
        oddities.collider = [](int) -> dColliderFn * { return nullptr; };
        oddities.aabb = oddBox;
        oddities.aabb_test = oddTest;
        m_oddClass = dCreateGeomClass(&oddities);
        m_oddities = 0.05;
    }
    m_world = dWorldCreate();
    m_smallest = uniform(-3, 1);
    m_largest = m_smallest + (chance(0.3) ? 6 : uniform(0, 2));
    m_extent = std::pow(dReal(10), (m_smallest + m_largest) / 2) * std::cbrt(dReal(recipe.geoms)) * uniform(dReal(0.3), 2);
    // Far below the origin the hash space's cell addresses wrap, and it loses pairs.
    dSetZero(m_centre, 4);
    if (chance(0.5))
        for (int axis = 0; axis < 3; ++axis) m_centre[axis] = uniform(-1, 1) * m_extent * (chance(0.5) ? 2 : 400);
    if (chance(0.3)) m_centre[0] = m_centre[1] = m_extent;
    if (m_kind == Kind::Sweep) chooseBounds();
    m_space = makeSpace(m_kind);
    for (int i = 0; i < recipe.geoms; ++i) m_geoms.push_back(make());
    addProbes();
}

// Bounds that a sort and single precision make something of.
void RandomSpace::chooseBounds() {
    m_oddities = !chance(0.3) ? 0 : m_isCrowd ? 0.02 : 0.2;
    m_hasGrid = chance(0.4);
    if (m_hasGrid) dSetZero(m_centre, 4);
    // Single precision rounds neighbours together.
    if (chance(0.2)) m_centre[0] = m_centre[1] = m_centre[2] = m_extent * dReal(3e6) * (chance(0.5) ? 1 : -1);
}

RandomSpace::~RandomSpace() {
    for (const dGeomID probe : m_probes) dGeomDestroy(probe);
    dSpaceDestroy(m_others);
    dSpaceDestroy(m_space);
    dWorldDestroy(m_world);
}

dSpaceID RandomSpace::makeSpace(Kind kind) {
    if (kind == Kind::Simple) return dSimpleSpaceCreate(nullptr);
    if (kind == Kind::QuadTree) return makeQuadTree();
    if (kind == Kind::Sweep) return makeSweep();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    if (chance(0.5)) {
        const int lowest = below(12) - 8;
        dHashSpaceSetLevels(space, lowest, lowest + below(10));
    }
    return space;
}

// Makes a tree of random depth and size near the geoms.
dSpaceID RandomSpace::makeQuadTree() {
    dVector3 centre, extents;
    for (int axis = 0; axis < 3; ++axis) {
        centre[axis] = m_centre[axis] + (chance(0.3) ? uniform(-m_extent, m_extent) : 0);
        extents[axis] = chance(0.05) ? 0 : m_extent * (chance(0.5) ? dReal(1.1) : uniform(dReal(0.01), 3));
    }
    return dQuadTreeSpaceCreate(nullptr, centre, extents, below(7));
}

// Along axes in any order, or not all three: then there are more pairs.
dSpaceID RandomSpace::makeSweep() {
    constexpr int orders[] = {dSAP_AXES_XYZ, dSAP_AXES_XZY, dSAP_AXES_YXZ, dSAP_AXES_YZX, dSAP_AXES_ZXY, dSAP_AXES_ZYX};
    return dSweepAndPruneSpaceCreate(nullptr, m_isCrowd || chance(0.8) ? orders[below(6)] : below(64));
}

void RandomSpace::addProbes() {
    m_others = dSimpleSpaceCreate(nullptr);
    for (int i = 0; i < 16; ++i) {
        const dGeomID geom = makeShape();
        number(geom);
        dSpaceAdd(m_others, geom);
    }
    for (int i = 0; i < 8; ++i) {
        m_probes.push_back(makeShape());
        number(m_probes.back());
    }
    for (const dGeomID wide : {dCreateRay(nullptr, m_extent), dCreateBox(nullptr, m_extent, size(), size())}) {
        m_probes.push_back(wide);
        number(wide);
        place(wide);
    }
}

void RandomSpace::number(dGeomID geom) {
    dGeomSetData(geom, reinterpret_cast<void *>(static_cast<std::intptr_t>(m_nextNumber++)));
}

dGeomID RandomSpace::make() {
    dGeomID geom = chance(0.05) ? reinterpret_cast<dGeomID>(makeSubspace()) : makeShape();
    number(geom);
    dSpaceAdd(m_space, geom);
    return geom;
}

dGeomID RandomSpace::makeShape() {
    if (chance(m_oddities)) return makeOddity();
    if (chance(0.03)) return dCreatePlane(nullptr, below(2), below(2), 1, uniform(-1, 1) * m_extent);
    const dGeomID geom = makeSolid();
    if (chance(0.7)) {
        dBodyID body = !m_geoms.empty() && chance(0.1) ? dGeomGetBody(m_geoms.back()) : nullptr;
        dGeomSetBody(geom, body != nullptr ? body : dBodyCreate(m_world));
    }
    place(geom);
    if (chance(0.3)) dGeomSetCategoryBits(geom, 1u + below(7));
    if (chance(0.3)) dGeomSetCollideBits(geom, 1u + below(7));
    return geom;
}

dGeomID RandomSpace::makeSolid() {
    if (m_hasGrid) return dCreateBox(nullptr, m_extent / 4, m_extent / 4, m_extent / 4);
    switch (below(4)) {
    case 0: return dCreateSphere(nullptr, size());
    case 1: return dCreateBox(nullptr, size(), size(), size());
    case 2: return dCreateCapsule(nullptr, size(), size());
    default: return dCreateRay(nullptr, size() * 5);
    }
}

dGeomID RandomSpace::makeOddity() {
    const dGeomID geom = dCreateGeom(m_oddClass);
    dReal *const box = static_cast<dReal *>(dGeomGetClassData(geom));
    if (m_kind == Kind::Sweep && chance(0.5))
        for (int bound = 0; bound < 6; ++bound) box[bound] = oddBound();
    else
        makeOddBounds(box);
    if (chance(0.5)) dGeomSetBody(geom, dBodyCreate(m_world));
    return geom;
}

// Makes a box that is infinite, NaN, inverted, or a point.
void RandomSpace::makeOddBounds(dReal *box) {
    for (int axis = 0; axis < 3; ++axis) {
        const dReal middle = m_centre[axis] + onGrid(uniform(-m_extent, m_extent)), half = size();
        dReal &low = box[2 * axis], &high = box[2 * axis + 1];
        low = middle - half;
        high = middle + half;
        if (chance(0.1)) low = high;
        if (chance(0.1)) std::swap(low, high);
        if (chance(0.03)) low = -dInfinity;
        if (chance(0.03)) high = dInfinity;
        if (chance(0.03)) (chance(0.5) ? low : high) = std::nan("");
    }
}

// Any number, and such as single precision rounds to infinity or zero.
dReal RandomSpace::oddBound() {
    switch (below(40)) {
    case 0: return dInfinity;
    case 1: return -dInfinity;
    case 2: return m_hasGrid ? 0 : std::nan("");
    case 3: return -0.0;
    case 4: return dReal(1e30) * (chance(0.5) ? 1e9 : -1e9);
    case 5: return dReal(1e-40);
    default: return onGrid(uniform(-m_extent, m_extent));
    }
}

dReal RandomSpace::onGrid(dReal coordinate) {
    return m_hasGrid ? std::trunc(coordinate / m_extent * 8) * m_extent / 8 : coordinate;  // -0 too
}

// Moves with the geom, as far as it moves along x. A zero keeps its sign until then.
void RandomSpace::oddBox(dGeomID geom, dReal aabb[6]) {
    const dReal *const box = static_cast<const dReal *>(dGeomGetClassData(geom));
    std::copy(box, box + 6, aabb);
    const dReal moved = dGeomGetPosition(geom)[0];
    if (moved == 0) return;
    aabb[0] += moved;
    aabb[1] += moved;
}

// The pairs depend on which geom is tested first.
int RandomSpace::oddTest(dGeomID geom, dGeomID other, dReal[6]) {
    if (asked != nullptr) asked->m_met.emplace_back(-1 - numberOf(geom), numberOf(other));
    return (numberOf(geom) + numberOf(other)) % 5 != 0;
}

dSpaceID RandomSpace::makeSubspace() {
    const Kind kinds[] = {Kind::Simple, Kind::Hash, Kind::QuadTree, Kind::Sweep};
    dSpaceID space = makeSpace(kinds[below(4)]);
    for (int i = below(4); i >= 0; --i) {
        dGeomID sphere = dCreateSphere(space, size());
        number(sphere);
        place(sphere);
    }
    return space;
}

void RandomSpace::place(dGeomID geom) {
    if (dGeomIsSpace(geom) || dGeomGetClass(geom) == dPlaneClass) return;
    dVector3 position;
    for (int axis = 0; axis < 3; ++axis) position[axis] = m_centre[axis] + onGrid(uniform(-m_extent, m_extent));
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
    switch (below(hasList() ? 10 : 12)) {
    case 0: place(geom); break;
    case 10: dSpaceClean(m_space); break;
    case 11: {
        dReal aabb[6];
        dGeomGetAABB(geom, aabb);
        break;
    }
    case 1: {
        const dGeomID old = geom;
        geom = make();
        dGeomDestroy(old);
        break;
    }
    case 2: reenter(geom); break;
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

// In a space with a list only a geom that has just moved: upstream fails an assertion where one that is clean is added
// before others have been cleaned.
void RandomSpace::reenter(dGeomID geom) {
    if (hasList() || chance(0.5)) place(geom);
    if (hasList() && (dGeomIsSpace(geom) || dGeomGetClass(geom) == dPlaneClass)) return;
    dSpaceRemove(m_space, geom);
    dSpaceAdd(m_space, geom);
    if (!hasList() && chance(0.3)) place(geom);
}

std::vector<std::pair<int, int>> RandomSpace::collide() {
    m_met.clear();
    asked = this;
    dSpaceCollide(m_space, this, met);
    asked = nullptr;
    return m_met;
}

std::vector<std::pair<int, int>> RandomSpace::probe() {
    m_met.clear();
    asked = this;
    for (int i = below(chance(0.1) ? 40 : 4); i > 0; --i) {  // few are answered otherwise than many
        const dGeomID outside = m_probes[below(static_cast<int>(m_probes.size()))];
        if (chance(0.5)) place(outside);
        m_mover = dGeomGetBody(outside) == nullptr && chance(0.5) ? outside : nullptr;  // bodies may be shared
        probeWith(outside);
        m_mover = nullptr;
        probeWith(m_geoms[below(static_cast<int>(m_geoms.size()))]);
    }
    if (chance(0.2)) probeWith(reinterpret_cast<dGeomID>(m_others));
    asked = nullptr;
    return m_met;
}

void RandomSpace::probeWith(dGeomID geom) {
    m_met.emplace_back(numberOf(geom), numberOf(geom));
    const auto space = reinterpret_cast<dGeomID>(m_space);
    if (chance(0.5)) dSpaceCollide2(space, geom, this, met);
    else dSpaceCollide2(geom, space, this, met);
}

void RandomSpace::met(void *self, dGeomID a, dGeomID b) {
    RandomSpace &space = *static_cast<RandomSpace *>(self);
    space.m_met.emplace_back(numberOf(a), numberOf(b));
    if (space.m_mover != nullptr && space.chance(0.2)) {
        // Upstream requires that its box is known before the next geom.
        space.place(space.m_mover);
        dReal aabb[6];
        dGeomGetAABB(space.m_mover, aabb);
    }
    if (space.m_togglesLeft == 0 || !space.chance(0.1)) return;
    --space.m_togglesLeft;
    dGeomID geom = space.chance(0.5) ? a : space.m_geoms[space.below(static_cast<int>(space.m_geoms.size()))];
    dGeomIsEnabled(geom) ? dGeomDisable(geom) : dGeomEnable(geom);
}

std::vector<int> RandomSpace::list() const {
    std::vector<int> numbers;
    if (m_kind == Kind::QuadTree) return numbers;
    for (int i = 0; i < dSpaceGetNumGeoms(m_space); ++i) numbers.push_back(numberOf(dSpaceGetGeom(m_space, i)));
    return numbers;
}

}  // namespace collision
