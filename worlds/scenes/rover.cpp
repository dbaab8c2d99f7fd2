// A skid-steered rover among N static obstacles: the smallest world that people really run, and the
// one that any threading makes slower unless it keeps out of the way.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr Vector3 kChassis{REAL(0.5), REAL(0.38), REAL(0.2)};         // m
constexpr dReal kChassisMass = 15, kWheelMass = 1;                    // kg
constexpr dReal kWheelRadius = REAL(0.11), kWheelWidth = REAL(0.08);  // m
constexpr dReal kWheelTorque = 6;                                     // N·m
constexpr dReal kCell = 3;                                            // m of ground for each obstacle
constexpr dReal kWallHeight = REAL(0.5), kWallThickness = REAL(0.1);  // m
constexpr dReal kStepSize = REAL(0.016);                              // s

class Rover final : public WorldScene {
public:
    explicit Rover(const SceneOptions &options) : WorldScene(options, kStepSize) {
        m_surface.mu = REAL(0.5);  // enough to drive, too little to climb a wall
        addGround();
        addObstacles(options.size);
        addRover();
    }

    // Five seconds forward in changing curves, then two back and one of turning on the spot, so that
    // it gets clear of what it ran into.
    void control() override {
        constexpr double cycle = 8, forward = 5, back = 7;  // s
        const double phase = std::fmod(m_time, cycle);
        if (phase < forward)
            drive(6, 3 * std::sin(0.7 * m_time));
        else if (phase < back)
            drive(-4, 0);
        else
            drive(0, 4);
    }

private:
    // Boxes and cylinders on a jittered grid whose middle cell stays free for the rover, and a wall
    // around them.
    void addObstacles(int count) {
        Generator random(5);
        int columns = static_cast<int>(std::ceil(std::sqrt(count + 1)));
        if (columns % 2 == 0) ++columns;
        const int middle = columns * columns / 2;
        for (int i = 0; i < count; ++i) {
            const int cell = i < middle ? i : i + 1;
            const Vector3 center{
                kCell * (cell % columns - columns / 2) + random.between(REAL(-0.2), REAL(0.2)),
                kCell * (cell / columns - columns / 2) + random.between(REAL(-0.2), REAL(0.2)), REAL(0.3)};
            if (i % 2)
                addStaticBox(center, {REAL(0.5), REAL(0.4), REAL(0.6)}, random.between(0, 3));
            else
                addStaticCylinder(center, random.between(REAL(0.1), REAL(0.3)), REAL(0.6));
        }
        addWalls(kCell * columns);
    }

    void addWalls(dReal width) {
        const dReal at = width / 2;
        for (dReal side : {REAL(-1.0), REAL(1.0)}) {
            addStaticBox({side * at, 0, kWallHeight / 2}, {kWallThickness, width, kWallHeight});
            addStaticBox({0, side * at, kWallHeight / 2}, {width, kWallThickness, kWallHeight});
        }
    }

    void addRover() {
        const dBodyID chassis = addBox({0, 0, kWheelRadius + REAL(0.06)}, kChassis, kChassisMass);
        // The wheels are so close that no corner of an obstacle fits between two of them.
        const dReal axleX = REAL(0.13), axleY = kChassis.y / 2 + kWheelWidth / 2 + REAL(0.01);
        for (dReal x : {axleX, -axleX}) {
            m_left.push_back(addWheel(chassis, {x, axleY, kWheelRadius}));
            m_right.push_back(addWheel(chassis, {x, -axleY, kWheelRadius}));
        }
    }

    dJointID addWheel(dBodyID chassis, const Vector3 &at) {
        const dBodyID wheel = addCylinder(at, kAxisY, kWheelRadius, kWheelWidth, kWheelMass);
        const dJointID axle = addHinge(wheel, chassis, at, kAxisY);
        dJointSetHingeParam(axle, dParamFMax, kWheelTorque);
        return axle;
    }

    // Speeds of the wheels in rad/s: what both sides share, and what the right side has more.
    void drive(double speed, double turn) {
        setSpeed(m_left, static_cast<dReal>(speed - turn));
        setSpeed(m_right, static_cast<dReal>(speed + turn));
    }

    static void setSpeed(const std::vector<dJointID> &axles, dReal speed) {
        for (dJointID axle : axles) dJointSetHingeParam(axle, dParamVel, speed);
    }

    std::vector<dJointID> m_left, m_right;
};

}  // namespace

std::unique_ptr<Scene> makeRover(const SceneOptions &options) { return std::make_unique<Rover>(options); }

}  // namespace scenes
