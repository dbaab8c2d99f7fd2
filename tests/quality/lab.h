// A scene that its maker furnishes from outside: surfaces by a function, a controller by another.
#pragma once

#include "scenes/world_scene.h"

#include <functional>

namespace quality {

class Lab final : public scenes::WorldScene {
public:
    using SurfaceFunction = std::function<dSurfaceParameters(dGeomID, dGeomID)>;

    explicit Lab(scenes::Stepper stepper, dReal stepSize = REAL(0.01));

    dSurfaceParameters &surfaceOfAll() { return m_surface; }
    void setSurface(SurfaceFunction surface) { m_surfaceOf = std::move(surface); }
    // Called before each frame with its number, from 0.
    void setController(std::function<void(int)> controller) { m_controller = std::move(controller); }

    void control() override;

    // A kinematic body with a box.
    dBodyID addKinematicBox(const scenes::Vector3 &position, const scenes::Vector3 &sides);
    // A plane through the origin that rises along x by `angle` (rad).
    dGeomID addSlope(dReal angle);

private:
    dSurfaceParameters surface(dGeomID first, dGeomID second) const override;

    SurfaceFunction m_surfaceOf;
    std::function<void(int)> m_controller;
    int m_frame = 0;
};

// Turns a body about y.
void tilt(dBodyID body, dReal angle);

// A column of cubes that stand on one another, the lowest centre at `foot`, with a small offset each.
std::vector<dBodyID> addTower(Lab &lab, const scenes::Vector3 &foot, int height, dReal side, dReal mass);

}  // namespace quality
