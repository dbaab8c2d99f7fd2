// N buggies that drive in circles on hilly ground: chassis and four wheels on Hinge2 joints with
// suspension, the front wheels steered, the rear wheels driven.
#include "scenes/catalogue.h"
#include "scenes/terrain.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSpacing = 20;                                // m of ground for each buggy
constexpr dReal kMargin = 15;                                 // m of ground around all
constexpr Vector3 kChassis{REAL(1.6), REAL(0.8), REAL(0.3)};  // m
constexpr dReal kChassisMass = 250, kWheelMass = 12;          // kg
constexpr dReal kWheelRadius = REAL(0.3);                     // m
constexpr dReal kAxleX = REAL(0.7), kAxleY = REAL(0.65);      // m from the middle of the chassis
constexpr dReal kDriveTorque = 400, kSteerTorque = 400;       // N·m
constexpr dReal kSpringRate = 15000, kSpringDamping = 1200;   // N/m and N·s/m at each wheel
constexpr dReal kDrop = REAL(0.2);                            // m between wheels and the ground at the start
constexpr dReal kRange = 7;                                   // m from home where a buggy turns back
constexpr dReal kStepSize = REAL(0.01);                       // s

using AddGround = dGeomID (Terrain::*)(WorldScene &) const;

class Vehicles final : public WorldScene {
public:
    Vehicles(const SceneOptions &options, AddGround addGround) : WorldScene(options, kStepSize) {
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size)));
        const Terrain terrain(kSpacing * columns + 2 * kMargin);
        (terrain.*addGround)(*this);
        for (int i = 0; i < options.size; ++i)
            addBuggy(kMargin + kSpacing * (i % columns + REAL(0.5)),
                     kMargin + kSpacing * (i / columns + REAL(0.5)));
    }

    void control() override {
        for (std::size_t i = 0; i < m_rear.size(); ++i) {
            const double speed = 10 + 4 * std::sin(0.3 * m_time + static_cast<double>(i));  // rad/s
            dJointSetHinge2Param(m_rear[i], dParamVel2, static_cast<dReal>(speed));
        }
        for (std::size_t i = 0; i < m_buggies.size(); ++i) {
            const dReal target = steeringTarget(m_buggies[i]), gain = 10;  // rad; 1/s
            for (dJointID wheel : {m_front[2 * i], m_front[2 * i + 1]})
                dJointSetHinge2Param(wheel, dParamVel, gain * (target - dJointGetHinge2Angle1(wheel)));
        }
    }

private:
    struct Buggy {
        dBodyID chassis;
        Vector3 home;
    };

    // A wide circle, or a tighter curve towards home where the circle has drifted off.
    static dReal steeringTarget(const Buggy &buggy) {
        const dReal *at = dBodyGetPosition(buggy.chassis), *rotation = dBodyGetRotation(buggy.chassis);
        const dReal dx = buggy.home.x - at[0], dy = buggy.home.y - at[1];
        if (std::hypot(dx, dy) < kRange) return REAL(0.35);
        const dReal homeIsLeftBy = rotation[0] * dy - rotation[4] * dx;
        return homeIsLeftBy > 0 ? REAL(-0.5) : REAL(0.5);
    }

    void addBuggy(dReal x, dReal y) {
        // High enough for all wheels wherever the ground under the buggy is highest.
        dReal ground = -1;
        for (dReal dx : {-kAxleX, REAL(0.0), kAxleX})
            for (dReal dy : {-kAxleY, REAL(0.0), kAxleY})
                ground = std::fmax(ground, Terrain::height(x + dx, y + dy));
        const Vector3 hub{x, y, ground + kDrop + kWheelRadius};
        const dBodyID chassis = addBox(hub + Vector3{0, 0, REAL(0.2)}, kChassis, kChassisMass);
        m_buggies.push_back({chassis, hub});
        for (dReal side : {-kAxleY, kAxleY}) {
            m_front.push_back(addWheel(chassis, hub + Vector3{kAxleX, side, 0}));
            m_rear.push_back(addWheel(chassis, hub + Vector3{-kAxleX, side, 0}));
            steer(m_front.back());
            drive(m_rear.back());
        }
    }

    // A wheel is a sphere: ODE collides spheres well with meshes and height fields. The suspension's
    // ERP and CFM are those of a spring and damper with an implicit integrator (ODE manual 3.8.2).
    dJointID addWheel(dBodyID chassis, const Vector3 &at) {
        const dBodyID wheel = addSphere(at, kWheelRadius, kWheelMass);
        const dJointID joint = addHinge2(chassis, wheel, at, kAxisZ, REAL(-1.0) * kAxisY);
        const dReal spring = kStepSize * kSpringRate;
        dJointSetHinge2Param(joint, dParamSuspensionERP, spring / (spring + kSpringDamping));
        dJointSetHinge2Param(joint, dParamSuspensionCFM, 1 / (spring + kSpringDamping));
        return joint;
    }

    static void steer(dJointID wheel) {
        dJointSetHinge2Param(wheel, dParamFMax, kSteerTorque);
        dJointSetHinge2Param(wheel, dParamLoStop, REAL(-0.6));
        dJointSetHinge2Param(wheel, dParamHiStop, REAL(0.6));
    }

    static void drive(dJointID wheel) {
        dJointSetHinge2Param(wheel, dParamLoStop, 0);
        dJointSetHinge2Param(wheel, dParamHiStop, 0);
        dJointSetHinge2Param(wheel, dParamFMax2, kDriveTorque);
    }

    std::vector<Buggy> m_buggies;
    std::vector<dJointID> m_front, m_rear;  // two of each for each buggy
};

}  // namespace

std::unique_ptr<Scene> makeVehiclesOnMesh(const SceneOptions &options) {
    return std::make_unique<Vehicles>(options, &Terrain::addMesh);
}

std::unique_ptr<Scene> makeVehiclesOnHeightField(const SceneOptions &options) {
    return std::make_unique<Vehicles>(options, &Terrain::addHeightField);
}

}  // namespace scenes
