// N humanoids that bend their knees and swing their arms, each an island of its own.
//
// A humanoid has the size and weight of a grown man (1.7 m, 70 kg): 17 bodies in a tree of 16
// joints, every joint with one velocity motor and stops. Shoulders and hips are universal joints
// whose second axis, the twist, is held by its stops alone; all other joints are hinges. With two feet of
// four contacts each that makes 16 × 5 + 16 constraint rows and up to 24 for the contacts.
#include "scenes/catalogue.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSpacing = 3;             // m between humanoids: a fallen one reaches 1.7 m
constexpr dReal kStepSize = REAL(0.008);  // s
constexpr dReal kGain = 12;               // 1/s, motor speed per radian from the target
constexpr dReal kPeriod = 2;              // s
constexpr double kTwoPi = 6.283185307179586;

// A joint and its movement: the target angle is amplitude × (1 - cos(2πt / period + phase)) / 2.
struct Motor {
    dJointID joint;
    bool isUniversal;
    dReal amplitude;  // rad
    dReal phase;      // rad
};

enum class Side { Left, Right };

class Humanoids final : public WorldScene {
public:
    explicit Humanoids(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size)));
        for (int i = 0; i < options.size; ++i)
            addHumanoid({kSpacing * (i % columns), kSpacing * (i / columns), 0}, REAL(0.4) * i);
    }

    void control() override {
        for (const Motor &motor : m_motors) {
            const double swing = 1 - std::cos(kTwoPi * m_time / kPeriod + motor.phase);
            const dReal target = motor.amplitude * static_cast<dReal>(swing / 2);
            drive(motor, target);
        }
    }

private:
    static void drive(const Motor &motor, dReal target) {
        if (motor.isUniversal)
            dJointSetUniversalParam(motor.joint, dParamVel,
                                    kGain * (target - dJointGetUniversalAngle1(motor.joint)));
        else
            dJointSetHingeParam(motor.joint, dParamVel, kGain * (target - dJointGetHingeAngle(motor.joint)));
    }

    // Heights and sizes in metres, standing upright and looking along x.
    void addHumanoid(const Vector3 &at, dReal phase) {
        const dBodyID pelvis = addBox(at + Vector3{0, 0, REAL(0.98)}, {REAL(0.2), REAL(0.3), REAL(0.16)}, 10);
        const dBodyID chest = addBox(at + Vector3{0, 0, REAL(1.27)}, {REAL(0.2), REAL(0.32), REAL(0.4)}, 25);
        const dBodyID head = addSphere(at + Vector3{0, 0, REAL(1.6)}, REAL(0.11), 5);
        hinge(pelvis, chest, at + Vector3{0, 0, REAL(1.06)}, kAxisY, 200, REAL(0.05), phase);
        hinge(chest, head, at + Vector3{0, 0, REAL(1.49)}, kAxisZ, 20, REAL(0.3), phase);
        for (Side side : {Side::Left, Side::Right}) {
            addArm(chest, at, side, phase);
            addLeg(pelvis, at, side, phase);
        }
    }

    void addArm(dBodyID chest, const Vector3 &at, Side side, dReal phase) {
        const dReal y = side == Side::Left ? REAL(0.22) : REAL(-0.22);
        const dBodyID upper = addCapsule(at + Vector3{0, y, REAL(1.27)}, kAxisZ, REAL(0.045), REAL(0.2), 2);
        const dBodyID lower =
            addCapsule(at + Vector3{0, y, REAL(0.98)}, kAxisZ, REAL(0.035), REAL(0.18), REAL(1.5));
        const dBodyID hand =
            addBox(at + Vector3{0, y, REAL(0.79)}, {REAL(0.08), REAL(0.03), REAL(0.1)}, REAL(0.5));
        universal(chest, upper, at + Vector3{0, y, REAL(1.42)}, 40, REAL(-0.4), phase);
        hinge(upper, lower, at + Vector3{0, y, REAL(1.12)}, kAxisY, 30, REAL(-0.5), phase);
        hinge(lower, hand, at + Vector3{0, y, REAL(0.84)}, kAxisX, 5, REAL(0.2), phase);
    }

    // The hip has a link of its own between the joint that spreads the leg and the one that swings it. Ankle,
    // knee and hip bend by angles that add up to zero, so that the soles stay flat.
    void addLeg(dBodyID pelvis, const Vector3 &at, Side side, dReal phase) {
        const dReal y = side == Side::Left ? REAL(0.1) : REAL(-0.1);
        const dReal bend = REAL(0.25);  // rad
        const dBodyID hip = addSphere(at + Vector3{0, y, REAL(0.88)}, REAL(0.05), 1);
        const dBodyID thigh = addCapsule(at + Vector3{0, y, REAL(0.67)}, kAxisZ, REAL(0.06), REAL(0.26), 6);
        const dBodyID shin = addCapsule(at + Vector3{0, y, REAL(0.28)}, kAxisZ, REAL(0.045), REAL(0.28), 3);
        const dBodyID foot =
            addBox(at + Vector3{REAL(0.04), y, REAL(0.04)}, {REAL(0.26), REAL(0.12), REAL(0.08)}, 1);
        hinge(pelvis, hip, at + Vector3{0, y, REAL(0.9)}, kAxisX, 100, 0, phase);
        universal(hip, thigh, at + Vector3{0, y, REAL(0.86)}, 200, -bend, phase);
        hinge(thigh, shin, at + Vector3{0, y, REAL(0.47)}, kAxisY, 200, 2 * bend, phase);
        hinge(shin, foot, at + Vector3{0, y, REAL(0.08)}, kAxisY, 150, -bend, phase);
    }

    // Torques in N·m. ODE's angle is that of the first body seen from the second, hence the sign
    // of the axis: a positive angle rotates the second body, the outer one, about `axis`.
    void hinge(dBodyID inner, dBodyID outer, const Vector3 &anchor, const Vector3 &axis, dReal torque,
               dReal amplitude, dReal phase) {
        const dJointID joint = addHinge(outer, inner, anchor, axis);
        dJointSetHingeParam(joint, dParamLoStop, REAL(-1.5));
        dJointSetHingeParam(joint, dParamHiStop, REAL(1.5));
        dJointSetHingeParam(joint, dParamFMax, torque);
        m_motors.push_back({joint, false, amplitude, phase});
    }

    void universal(dBodyID inner, dBodyID outer, const Vector3 &anchor, dReal torque, dReal amplitude,
                   dReal phase) {
        const dJointID joint = addUniversal(outer, inner, anchor, kAxisY, kAxisZ);
        dJointSetUniversalParam(joint, dParamLoStop, REAL(-1.5));
        dJointSetUniversalParam(joint, dParamHiStop, REAL(1.5));
        dJointSetUniversalParam(joint, dParamFMax, torque);
        dJointSetUniversalParam(joint, dParamLoStop2, REAL(-0.02));
        dJointSetUniversalParam(joint, dParamHiStop2, REAL(0.02));
        m_motors.push_back({joint, true, amplitude, phase});
    }

    std::vector<Motor> m_motors;
};

}  // namespace

std::unique_ptr<Scene> makeHumanoids(const SceneOptions &options) {
    return std::make_unique<Humanoids>(options);
}

}  // namespace scenes
