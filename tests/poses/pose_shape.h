// One geom of each class of ODE, of a size and in a pose that are drawn.
//
// Half of the draws use round numbers only: multiples of 90 degrees, sizes and positions in eighths of a metre. There
// faces lie in one plane, edges cross at right angles and depths are zero, so that signs of zeros and ties
// decide.
#pragma once

#include "scenarios/dice.h"
#include "scenarios/ground_grid.h"
#include "scenarios/prism.h"

#include <ode/ode.h>

#include <vector>

namespace poses {

enum class Kind { Sphere, Box, Capsule, Cylinder, Convex, Mesh, Sheet, Plane, Ray, Heights, Transform };
constexpr Kind allKinds[] = {Kind::Sphere, Kind::Box,     Kind::Capsule,  Kind::Cylinder,
                             Kind::Convex, Kind::Mesh,    Kind::Sheet,    Kind::Plane,
                             Kind::Ray,    Kind::Heights, Kind::Transform};
const char *nameOf(Kind kind);

inline bool isMesh(Kind kind) { return kind == Kind::Mesh || kind == Kind::Sheet; }

// Data that geoms share, alive as long as they are.
struct Materials {
    Materials();

    exactness::Prism hexagon;
    exactness::GridMesh sheet;      // flat, open, 4 x 4 squares of an eighth of a metre
    exactness::HeightGrid heights;  // steps of an eighth of a metre
};

class PoseShape {
public:
    PoseShape(Kind kind, const Materials &materials);
    ~PoseShape();
    PoseShape(const PoseShape &) = delete;
    PoseShape &operator=(const PoseShape &) = delete;

    // Draws size, pose and, of a ray, what it is asked to report.
    void draw(exactness::Dice &dice, bool round);

    Kind kind() const { return m_kind; }
    Kind solidKind() const { return m_solidKind; }  // of a transform, that of its child
    dGeomID geom() const { return m_geom; }
    bool owns(dGeomID geom) const { return geom == m_geom || geom == m_child; }

private:
    void resize(dGeomID geom, Kind kind, exactness::Dice &dice, bool round);
    void drawChild(exactness::Dice &dice, bool round);

    Kind m_kind, m_solidKind;
    const Materials &m_materials;
    dGeomID m_geom, m_child = nullptr;
};

}  // namespace poses
