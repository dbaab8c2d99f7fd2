#include "pose_shape.h"

#include "scenarios/shapes.h"

#include <cmath>

namespace poses {

namespace {

using exactness::Dice;
using exactness::Shape;

constexpr dReal eighth = 0.125;  // m

dReal length(Dice &dice, bool round) {
    return round ? eighth * (1 + dice.below(5)) : dice.between(0.05, 0.7);
}

dReal coordinate(Dice &dice, bool round) {
    return round ? eighth * (dice.below(7) - 3) : dice.between(-0.4, 0.4);
}

// Rows of the matrix are the axes in any order and direction.
void quarterTurn(dMatrix3 turn, Dice &dice) {
    dRSetIdentity(turn);
    const int first = dice.below(3), second = (first + 1 + dice.below(2)) % 3, third = 3 - first - second;
    const dReal one = dice.oneIn(2) ? 1 : -1, other = dice.oneIn(2) ? 1 : -1;
    const bool even = (second - first + 3) % 3 == 1;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) turn[4 * i + j] = 0;
    turn[first] = one;
    turn[4 + second] = other;
    turn[8 + third] = even ? one * other : -one * other;
}

void anyTurn(dMatrix3 turn, Dice &dice) {
    const auto axis = dice.within(1);
    dRFromAxisAndAngle(turn, axis.x, axis.y, axis.z, dice.between(-M_PI, M_PI));
}

void place(dGeomID geom, Dice &dice, bool round) {
    dMatrix3 turn;
    round ? quarterTurn(turn, dice) : anyTurn(turn, dice);
    dGeomSetRotation(geom, turn);
    const dReal x = coordinate(dice, round), y = coordinate(dice, round);
    dGeomSetPosition(geom, x, y, coordinate(dice, round));
}

dGeomID create(Kind kind, const Materials &materials) {
    switch (kind) {
        case Kind::Sphere:
            return exactness::createShape(nullptr, Shape::Sphere);
        case Kind::Box:
            return exactness::createShape(nullptr, Shape::Box);
        case Kind::Capsule:
            return exactness::createShape(nullptr, Shape::Capsule);
        case Kind::Cylinder:
            return exactness::createShape(nullptr, Shape::Cylinder);
        case Kind::Convex:
            return exactness::createShape(nullptr, Shape::Convex);
        case Kind::Mesh:
            return exactness::createShape(nullptr, Shape::Mesh);
        case Kind::Sheet:
            return dCreateTriMesh(nullptr, materials.sheet.data(), nullptr, nullptr, nullptr);
        case Kind::Plane:
            return dCreatePlane(nullptr, 0, 0, 1, 0);
        case Kind::Ray:
            return dCreateRay(nullptr, 1);
        case Kind::Heights:
            return materials.heights.createGeom(nullptr);
        case Kind::Transform:
            break;
    }
    const dGeomID transform = dCreateGeomTransform(nullptr);
    dGeomTransformSetCleanup(transform, 1);
    return transform;
}

void drawPlane(dGeomID plane, Dice &dice, bool round) {
    if (!round) {
        const auto normal = dice.within(1);
        dGeomPlaneSetParams(plane, normal.x, normal.y, normal.z + 1.5, coordinate(dice, false));
        return;
    }
    dReal normal[3] = {0, 0, 0};
    normal[dice.below(3)] = dice.oneIn(2) ? 1 : -1;
    dGeomPlaneSetParams(plane, normal[0], normal[1], normal[2], coordinate(dice, true));
}

}  // namespace

const char *nameOf(Kind kind) {
    static const char *const names[] = {"sphere", "box",   "capsule", "cylinder", "convex",   "mesh",
                                        "sheet",  "plane", "ray",     "heights",  "transform"};
    return names[static_cast<int>(kind)];
}

Materials::Materials()
    : hexagon(6, 0.25, 0.5),
      sheet({5, eighth, [](int, int) { return dReal(0); }}),
      heights({9, eighth, [](int x, int y) { return eighth * ((x * 5 + y * 3) % 4 - 2); }}, {}) {}

PoseShape::PoseShape(Kind kind, const Materials &materials)
    : m_kind(kind), m_solidKind(kind), m_materials(materials), m_geom(create(kind, materials)) {}

PoseShape::~PoseShape() { dGeomDestroy(m_geom); }

void PoseShape::draw(Dice &dice, bool round) {
    if (m_kind == Kind::Transform) drawChild(dice, round);
    resize(m_geom, m_kind, dice, round);
    if (m_kind != Kind::Plane) place(m_geom, dice, round);
}

void PoseShape::drawChild(Dice &dice, bool round) {
    static constexpr Kind kinds[] = {Kind::Sphere, Kind::Box,  Kind::Capsule, Kind::Cylinder,
                                     Kind::Convex, Kind::Mesh, Kind::Sheet,   Kind::Ray};
    m_solidKind = kinds[dice.below(sizeof(kinds) / sizeof(kinds[0]))];
    m_child = create(m_solidKind, m_materials);
    resize(m_child, m_solidKind, dice, round);
    place(m_child, dice, round);
    dGeomTransformSetGeom(m_geom, m_child);
    dGeomTransformSetInfo(m_geom, dice.below(2));
}

void PoseShape::resize(dGeomID geom, Kind kind, Dice &dice, bool round) {
    const dReal first = length(dice, round), second = length(dice, round), third = length(dice, round);
    switch (kind) {
        case Kind::Sphere:
            return dGeomSphereSetRadius(geom, first);
        case Kind::Box:
            return dGeomBoxSetLengths(geom, first, second, third);
        case Kind::Capsule:
            return dGeomCapsuleSetParams(geom, first / 2, second);
        case Kind::Cylinder:
            return dGeomCylinderSetParams(geom, first / 2, second);
        case Kind::Plane:
            return drawPlane(geom, dice, round);
        case Kind::Convex:
            if (dice.oneIn(2)) m_materials.hexagon.giveTo(geom);
            return;
        case Kind::Ray: {
            dGeomRaySetLength(geom, 2 * first);
            dGeomRaySetFirstContact(geom, dice.below(2));
            dGeomRaySetBackfaceCull(geom, dice.below(2));
            return dGeomRaySetClosestHit(geom, dice.below(2));
        }
        case Kind::Mesh:
        case Kind::Sheet:
        case Kind::Heights:
        case Kind::Transform:
            return;
    }
}

}  // namespace poses
