#include "lab.h"

#include "scenes/generator.h"

#include <cmath>

namespace quality {

using scenes::Vector3;

Lab::Lab(scenes::Stepper stepper, dReal stepSize)
    : WorldScene([&] {
          scenes::SceneOptions options;
          options.stepper = stepper;
          return options;
      }(), stepSize) {}

void Lab::control() {
    if (m_controller) m_controller(m_frame);
    ++m_frame;
}

dSurfaceParameters Lab::surface(dGeomID first, dGeomID second) const {
    return m_surfaceOf ? m_surfaceOf(first, second) : WorldScene::surface(first, second);
}

dBodyID Lab::addKinematicBox(const Vector3 &position, const Vector3 &sides) {
    const dBodyID body = addBox(position, sides, 1);
    dBodySetKinematic(body);
    return body;
}

dGeomID Lab::addSlope(dReal angle) {
    return add(dCreatePlane(space(), -std::sin(angle), 0, std::cos(angle), 0));
}

void tilt(dBodyID body, dReal angle) {
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, 1, 0, angle);
    dBodySetRotation(body, rotation);
}

std::vector<dBodyID> addTower(Lab &lab, const Vector3 &foot, int height, dReal side, dReal mass) {
    constexpr dReal kJitter = REAL(0.01);  // of the side
    scenes::Generator random(static_cast<unsigned>(height));
    std::vector<dBodyID> boxes;
    for (int i = 0; i < height; ++i) {
        const Vector3 offset{random.between(-kJitter, kJitter) * side, random.between(-kJitter, kJitter) * side, i * side};
        boxes.push_back(lab.addBox(foot + offset, {side, side, side}, mass));
    }
    return boxes;
}

}  // namespace quality
