// Convex polyhedra for dCreateConvex, with the origin inside.
//
// ODE reads the arrays as long as the geom lives: a scene keeps the polyhedron (WorldScene::keep).
#pragma once

#include "scenes/vector3.h"

#include <vector>

namespace scenes {

class Polyhedron {
public:
    using Face = std::vector<unsigned>;  // indices of its corners, counterclockwise seen from outside

    Polyhedron(std::vector<Vector3> corners, const std::vector<Face> &faces);

    static Polyhedron octahedron(const Vector3 &halfAxes);
    static Polyhedron hexagonalPrism(dReal radius, dReal height);  // along z
    static Polyhedron cutCube(dReal side);  // its corners cut off through the middles of its edges
    static Polyhedron hullOf(const std::vector<Vector3> &points);  // each of which is a corner; time: the fourth power of their number

    dGeomID createGeom(dSpaceID space) const;

    dReal meanRadius() const;  // m, mean distance of the corners from the origin
    dReal volume() const;      // m³

    const std::vector<Vector3> &corners() const { return m_corners; }
    // Four numbers a face, a b c d: what is inside has a x + b y + c z < d; (a b c) is a unit vector.
    const std::vector<dReal> &planes() const { return m_planes; }
    // For each face the number of its corners, then their indices.
    const std::vector<unsigned> &polygons() const { return m_polygons; }

private:
    std::vector<Vector3> m_corners;
    std::vector<dReal> m_planes;
    std::vector<unsigned> m_polygons;
};

}  // namespace scenes
