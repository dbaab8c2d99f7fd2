// A camera infinitely far away (parallel projection), z up. Lengths on the screen are those of the world.
#pragma once

#include "render/vector.h"

namespace render {

struct Point {
    double x = 0, y = 0;  // right, down
};

class Camera {
public:
    // Units: degrees. The viewer is in the direction `azimuth` from the scene (0: along +x, 90: along +y),
    // `elevation` above the horizon.
    Camera(double azimuth, double elevation);

    Point project(const Vector &point) const { return {dot(m_right, point), -dot(m_up, point)}; }
    double nearness(const Vector &point) const { return dot(m_toViewer, point); }  // larger is nearer
    const Vector &toViewer() const { return m_toViewer; }
    const Vector &right() const { return m_right; }
    const Vector &up() const { return m_up; }

private:
    Vector m_toViewer, m_right, m_up;
};

}  // namespace render
