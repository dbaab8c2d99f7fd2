#include "prism.h"

#include <cmath>

namespace exactness {

// Corners of the base and of the lid alternately.
Prism::Prism(int corners, dReal radius, dReal height) : m_corners(corners) {
    const dReal step = 2 * M_PI / corners;
    const auto point = [corners](int corner, int isLid) {
        return static_cast<unsigned>(corner % corners * 2 + isLid);
    };
    for (int i = 0; i < corners; ++i) {
        for (dReal z : {-height / 2, height / 2})
            m_points.insert(m_points.end(), {radius * std::cos(step * i), radius * std::sin(step * i), z});
        const dReal middle = step * (i + dReal(0.5));
        m_planes.insert(m_planes.end(), {std::cos(middle), std::sin(middle), 0, radius * std::cos(step / 2)});
        m_polygons.insert(m_polygons.end(), {4, point(i, 0), point(i + 1, 0), point(i + 1, 1), point(i, 1)});
    }
    for (int isLid : {0, 1}) {
        m_planes.insert(m_planes.end(), {0, 0, isLid == 1 ? dReal(1) : dReal(-1), height / 2});
        m_polygons.push_back(corners);
        for (int i = 0; i < corners; ++i)
            m_polygons.push_back(point(isLid == 1 ? i : corners - 1 - i, isLid));
    }
}

dGeomID Prism::createGeom(dSpaceID space) const {
    return dCreateConvex(space, m_planes.data(), m_corners + 2, m_points.data(), 2 * m_corners,
                         m_polygons.data());
}

void Prism::setHeight(dReal height) {
    for (std::size_t z = 2; z < m_points.size(); z += 3) m_points[z] = m_points[z] < 0 ? -height / 2 : height / 2;
    m_planes[m_planes.size() - 1] = m_planes[m_planes.size() - 5] = height / 2;
}

void Prism::giveTo(dGeomID convex) const {
    dGeomSetConvex(convex, m_planes.data(), m_corners + 2, m_points.data(), 2 * m_corners, m_polygons.data());
}

}  // namespace exactness
