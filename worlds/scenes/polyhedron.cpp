#include "scenes/polyhedron.h"

#include <algorithm>
#include <cmath>

namespace scenes {

namespace {

dReal dot(const Vector3 &a, const Vector3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector3 cross(const Vector3 &a, const Vector3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

dReal length(const Vector3 &a) { return std::sqrt(dot(a, a)); }

// Adds the face of the hull that has the three corners, unless it is there already. Three corners have none if they lie on a line, or if there are
// points on both sides of them.
void addFaceOf(const std::vector<Vector3> &points, unsigned i, unsigned j, unsigned k, std::vector<Polyhedron::Face> &faces) {
    Vector3 normal = cross(points[j] - points[i], points[k] - points[i]);
    const dReal size = length(normal), tolerance = REAL(1e-6) * std::sqrt(size);  // m: of the points' distances
    if (!(size > 0)) return;
    normal = 1 / size * normal;
    Polyhedron::Face face;
    bool isAbove = false, isBelow = false;
    for (unsigned p = 0; p < points.size(); ++p) {
        const dReal above = dot(normal, points[p] - points[i]);
        if (std::fabs(above) <= tolerance)
            face.push_back(p);
        else
            (above > 0 ? isAbove : isBelow) = true;
    }
    if (isAbove && isBelow) return;
    if (isAbove) normal = -1 * normal;
    Vector3 centre;
    for (const unsigned p : face) centre = centre + REAL(1.0) / static_cast<dReal>(face.size()) * points[p];
    const Vector3 across = points[face[0]] - centre, along = cross(normal, across);
    const auto angle = [&](unsigned p) { return std::atan2(dot(along, points[p] - centre), dot(across, points[p] - centre)); };
    std::sort(face.begin() + 1, face.end(), [&](unsigned a, unsigned b) {
        const dReal first = angle(a), second = angle(b);
        return (first < 0 ? first + 7 : first) < (second < 0 ? second + 7 : second);
    });
    if (std::find(faces.begin(), faces.end(), face) == faces.end()) faces.push_back(face);
}

}  // namespace

Polyhedron::Polyhedron(std::vector<Vector3> corners, const std::vector<Face> &faces)
    : m_corners(std::move(corners)) {
    for (const Face &face : faces) {
        const Vector3 &corner = m_corners[face[0]];
        const Vector3 across = cross(m_corners[face[1]] - corner, m_corners[face[2]] - corner);
        const Vector3 normal = (1 / length(across)) * across;
        m_planes.insert(m_planes.end(), {normal.x, normal.y, normal.z, dot(normal, corner)});
        m_polygons.push_back(static_cast<unsigned>(face.size()));
        m_polygons.insert(m_polygons.end(), face.begin(), face.end());
    }
}

Polyhedron Polyhedron::octahedron(const Vector3 &h) {
    enum : unsigned { right, left, back, front, top, bottom };
    return {{{h.x, 0, 0}, {-h.x, 0, 0}, {0, h.y, 0}, {0, -h.y, 0}, {0, 0, h.z}, {0, 0, -h.z}},
            {{right, back, top},
             {back, left, top},
             {left, front, top},
             {front, right, top},
             {back, right, bottom},
             {left, back, bottom},
             {front, left, bottom},
             {right, front, bottom}}};
}

Polyhedron Polyhedron::hexagonalPrism(dReal radius, dReal height) {
    constexpr unsigned kSides = 6;  // corner k of the bottom is k, that of the top k + kSides
    std::vector<Vector3> corners;
    Face top, bottom;
    std::vector<Face> faces;
    for (const dReal z : {-height / 2, height / 2})
        for (unsigned k = 0; k < kSides; ++k) {
            const dReal angle = REAL(1.0471975511965976) * static_cast<dReal>(k);  // 60° each
            corners.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
        }
    for (unsigned k = 0; k < kSides; ++k) {
        const unsigned next = (k + 1) % kSides;
        bottom.push_back(kSides - 1 - k);
        top.push_back(kSides + k);
        faces.push_back({k, next, kSides + next, kSides + k});
    }
    faces.push_back(bottom);
    faces.push_back(top);
    return {corners, faces};
}

Polyhedron Polyhedron::cutCube(dReal side) {
    const dReal h = side / 2;
    // The middles of its edges: four each at the top, half way up and at the bottom, counterclockwise seen
    // from above. Middle k lies between top k and top k + 1.
    const std::vector<Vector3> corners = {{h, 0, h},  {0, h, h},  {-h, 0, h},  {0, -h, h},
                                          {h, h, 0},  {-h, h, 0}, {-h, -h, 0}, {h, -h, 0},
                                          {h, 0, -h}, {0, h, -h}, {-h, 0, -h}, {0, -h, -h}};
    constexpr unsigned kTop = 0, kMiddle = 4, kBottom = 8;
    std::vector<Face> faces = {{kTop, kTop + 1, kTop + 2, kTop + 3},
                               {kBottom + 3, kBottom + 2, kBottom + 1, kBottom}};
    for (unsigned k = 0; k < 4; ++k) {
        const unsigned next = (k + 1) % 4;
        faces.push_back({kTop + k, kMiddle + k, kTop + next});
        faces.push_back({kBottom + next, kMiddle + k, kBottom + k});
        faces.push_back({kMiddle + k, kBottom + next, kMiddle + next, kTop + next});
    }
    return {corners, faces};
}

Polyhedron Polyhedron::hullOf(const std::vector<Vector3> &points) {
    std::vector<Face> faces;
    for (unsigned i = 0; i < points.size(); ++i)
        for (unsigned j = i + 1; j < points.size(); ++j)
            for (unsigned k = j + 1; k < points.size(); ++k) addFaceOf(points, i, j, k, faces);
    return {points, faces};
}

dGeomID Polyhedron::createGeom(dSpaceID space) const {
    return dCreateConvex(space, m_planes.data(), static_cast<unsigned>(m_planes.size() / 4), &m_corners[0].x,
                         static_cast<unsigned>(m_corners.size()), m_polygons.data());
}

dReal Polyhedron::meanRadius() const {
    dReal sum = 0;
    for (const Vector3 &corner : m_corners) sum += length(corner);
    return sum / static_cast<dReal>(m_corners.size());
}

// Of pyramids from the origin to triangles of each face.
dReal Polyhedron::volume() const {
    dReal sum = 0;
    for (std::size_t at = 0; at < m_polygons.size(); at += m_polygons[at] + 1)
        for (unsigned i = 2; i < m_polygons[at]; ++i)
            sum += dot(m_corners[m_polygons[at + 1]], cross(m_corners[m_polygons[at + i]], m_corners[m_polygons[at + i + 1]]));
    return sum / 6;
}

}  // namespace scenes
