// N small soccer fields side by side, each with a ball and six box robots of two wheels: the sizes
// and masses of Webots' "soccer" sample, with players that move at random.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kLength = REAL(1.5), kWidth = REAL(1.3);              // m, playing area
constexpr dReal kGoalMouth = REAL(0.4), kGoalDepth = REAL(0.1);       // m
constexpr dReal kBoard = REAL(0.01), kBoardHeight = REAL(0.05);       // m
constexpr dReal kSpacing = 2;                                         // m between fields
constexpr dReal kRobotSide = REAL(0.075), kRobotMass = REAL(0.2);     // m, kg
constexpr dReal kWheelRadius = REAL(0.02), kWheelMass = REAL(0.005);  // m, kg
constexpr dReal kWheelTorque = 10;                                    // N·m
constexpr dReal kWheelSpeed = 10;                                     // rad/s, 0.2 m/s
constexpr int kStepsPerCommand = 64;                                  // about one second
constexpr dReal kStepSize = REAL(0.016);                              // s

class Soccer final : public WorldScene {
public:
    explicit Soccer(const SceneOptions &options) : WorldScene(options, kStepSize), m_random(6) {
        m_surface.soft_cfm = REAL(1e-3);  // of Webots; a stiffer contact upsets robots this light
        addGround();
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size)));
        for (int i = 0; i < options.size; ++i) {
            const Vector3 center{kSpacing * (i % columns), kSpacing * (i / columns), 0};
            addBoards(center);
            addPlayers(center);
        }
    }

    // A player drives straight on or turns on the spot. All draw a new command at the same step.
    void control() override {
        if (m_step++ % kStepsPerCommand != 0) return;
        for (const Axles &axles : m_robots) {
            const bool turns = m_random.next() % 3 == 0;
            dJointSetHingeParam(axles.left, dParamVel, turns ? -kWheelSpeed : kWheelSpeed);
            dJointSetHingeParam(axles.right, dParamVel, kWheelSpeed);
        }
    }

private:
    struct Axles {
        dJointID left, right;
    };

    void addBoards(const Vector3 &center) {
        const dReal endLength = (kWidth - kGoalMouth) / 2, endY = (kWidth + kGoalMouth) / 4;
        for (dReal side : {REAL(-1.0), REAL(1.0)}) {
            const dReal goalX = side * kLength / 2;
            board(center, {0, side * kWidth / 2, 0}, {kLength, kBoard, kBoardHeight});
            board(center, {goalX, endY, 0}, {kBoard, endLength, kBoardHeight});
            board(center, {goalX, -endY, 0}, {kBoard, endLength, kBoardHeight});
            board(center, {goalX + side * kGoalDepth, 0, 0}, {kBoard, kGoalMouth, kBoardHeight});
            for (dReal post : {-kGoalMouth / 2, kGoalMouth / 2})
                board(center, {goalX + side * kGoalDepth / 2, post, 0}, {kGoalDepth, kBoard, kBoardHeight});
        }
    }

    void board(const Vector3 &center, const Vector3 &foot, const Vector3 &sides) {
        addStaticBox(center + foot + Vector3{0, 0, sides.z / 2}, sides);
    }

    void addPlayers(const Vector3 &center) {
        addSphere(center + Vector3{0, 0, REAL(0.03)}, REAL(0.021), REAL(0.05));
        for (dReal half : {REAL(-1.0), REAL(1.0)})
            for (dReal y : {REAL(-0.4), REAL(0.0), REAL(0.4)})
                addRobot(center + Vector3{half * (y == 0 ? REAL(0.6) : REAL(0.3)), y, 0});
    }

    void addRobot(const Vector3 &foot) {
        const Vector3 center = foot + Vector3{0, 0, kRobotSide / 2 + REAL(0.001)};
        const dBodyID body = addBox(center, {kRobotSide, kRobotSide, kRobotSide}, kRobotMass);
        const dReal y = REAL(0.045);
        m_robots.push_back({addWheel(body, foot + Vector3{0, y, kWheelRadius}),
                            addWheel(body, foot + Vector3{0, -y, kWheelRadius})});
    }

    dJointID addWheel(dBodyID body, const Vector3 &at) {
        const dBodyID wheel = addCylinder(at, kAxisY, kWheelRadius, REAL(0.01), kWheelMass);
        const dJointID axle = addHinge(wheel, body, at, kAxisY);
        dJointSetHingeParam(axle, dParamFMax, kWheelTorque);
        return axle;
    }

    Generator m_random;
    std::vector<Axles> m_robots;
    int m_step = 0;
};

}  // namespace

std::unique_ptr<Scene> makeSoccer(const SceneOptions &options) { return std::make_unique<Soccer>(options); }

}  // namespace scenes
