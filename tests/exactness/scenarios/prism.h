// The points, planes and polygons of a prism with a regular base, as ODE's convex geoms want them.
#pragma once

#include <ode/ode.h>

#include <vector>

namespace exactness {

class Prism {
public:
    Prism(int corners, dReal radius, dReal height);

    // The prism must outlive its geoms.
    dGeomID createGeom(dSpaceID space) const;
    void giveTo(dGeomID convex) const;
    void setHeight(dReal height);  // in place: geoms have it at once

private:
    int m_corners;
    std::vector<dReal> m_points, m_planes;
    std::vector<unsigned> m_polygons;
};

}  // namespace exactness
