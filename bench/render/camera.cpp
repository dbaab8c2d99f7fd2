#include "render/camera.h"

namespace render {

Camera::Camera(double azimuth, double elevation) {
    constexpr double kRadians = 3.14159265358979323846 / 180;
    const double a = azimuth * kRadians, e = elevation * kRadians;
    m_toViewer = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    m_right = {-std::sin(a), std::cos(a), 0};
    m_up = cross(m_toViewer, m_right);
}

}  // namespace render
