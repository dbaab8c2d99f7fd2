// N ragdolls that fall on the ground: ten bodies, hinges with stops at elbows and knees, ball joints
// with an Euler angle motor that stops them at neck, shoulders and hips.
#include "scenes/catalogue.h"
#include "scenes/generator.h"
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

constexpr dReal kSpacing = 3;             // m: a ragdoll that lies stretched out reaches 1.8 m
constexpr dReal kDrop = REAL(0.5);        // m, of the feet above the ground
constexpr dReal kStepSize = REAL(0.005);  // s

class Ragdolls final : public WorldScene {
public:
    explicit Ragdolls(const SceneOptions &options) : WorldScene(options, kStepSize) {
        addGround();
        Generator random(4);
        const int columns = static_cast<int>(std::ceil(std::sqrt(options.size)));
        for (int i = 0; i < options.size; ++i)
            addRagdoll({kSpacing * (i % columns), kSpacing * (i / columns), kDrop}, random);
    }

private:
    // Heights and sizes in metres, standing upright and looking along x.
    void addRagdoll(const Vector3 &at, Generator &random) {
        const dBodyID torso = addBox(at + Vector3{0, 0, REAL(1.2)}, {REAL(0.22), REAL(0.36), REAL(0.6)}, 35);
        const dBodyID head = addSphere(at + Vector3{0, 0, REAL(1.64)}, REAL(0.11), 5);
        socket(torso, head, at + Vector3{0, 0, REAL(1.51)}, REAL(0.5));
        for (dReal side : {REAL(1.0), REAL(-1.0)}) {
            addArm(torso, at, side);
            addLeg(torso, at, side);
        }
        // A push of its own for each, so that no two fall alike.
        dBodySetLinearVel(torso, random.between(-2, 2), random.between(-2, 2), 0);
        dBodySetAngularVel(torso, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    }

    void addArm(dBodyID torso, const Vector3 &at, dReal side) {
        const dReal shoulder = REAL(0.25) * side, height = REAL(1.43);
        const dBodyID upper = addCapsule(at + Vector3{0, shoulder + REAL(0.14) * side, height}, kAxisY,
                                         REAL(0.05), REAL(0.18), 2);
        const dBodyID lower = addCapsule(at + Vector3{0, shoulder + REAL(0.43) * side, height}, kAxisY,
                                         REAL(0.04), REAL(0.2), 2);
        socket(torso, upper, at + Vector3{0, shoulder, height}, 1);
        hinge(upper, lower, at + Vector3{0, shoulder + REAL(0.28) * side, height}, kAxisZ);
    }

    void addLeg(dBodyID torso, const Vector3 &at, dReal side) {
        const dReal y = REAL(0.1) * side;
        const dBodyID thigh = addCapsule(at + Vector3{0, y, REAL(0.65)}, kAxisZ, REAL(0.07), REAL(0.28), 8);
        const dBodyID shin = addCapsule(at + Vector3{0, y, REAL(0.22)}, kAxisZ, REAL(0.05), REAL(0.32), 4);
        socket(torso, thigh, at + Vector3{0, y, REAL(0.88)}, REAL(0.8));
        hinge(thigh, shin, at + Vector3{0, y, REAL(0.43)}, kAxisY);
    }

    // A ball joint whose three Euler angles stay within ±`range` (rad).
    void socket(dBodyID inner, dBodyID outer, const Vector3 &anchor, dReal range) {
        addBall(inner, outer, anchor);
        const dJointID stops = addEulerMotor(inner, outer, kAxisX, kAxisZ);
        for (int group : {dParamGroup1, dParamGroup2, dParamGroup3}) {
            dJointSetAMotorParam(stops, group + dParamLoStop, -range);
            dJointSetAMotorParam(stops, group + dParamHiStop, range);
        }
    }

    void hinge(dBodyID inner, dBodyID outer, const Vector3 &anchor, const Vector3 &axis) {
        const dJointID joint = addHinge(inner, outer, anchor, axis);
        dJointSetHingeParam(joint, dParamLoStop, REAL(-2.0));
        dJointSetHingeParam(joint, dParamHiStop, REAL(0.05));
    }
};

}  // namespace

std::unique_ptr<Scene> makeRagdolls(const SceneOptions &options) {
    return std::make_unique<Ragdolls>(options);
}

}  // namespace scenes
