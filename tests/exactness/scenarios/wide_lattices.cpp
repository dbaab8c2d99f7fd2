// One island of so many joints that several workers step it together: every type of joint, motors, stops,
// joints that go.
#include "additions.h"
#include "joint_lattice.h"

#include <cmath>
#include <string>
#include <utility>

namespace exactness {

namespace {

using SetParameter = void (*)(dJointID, int, dReal);

// Every type of joint between two bodies, alternately.
class EveryJoint : public JointLattice {
public:
    explicit EveryJoint(Stepper stepper) : JointLattice(stepper) { build(); }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        const dJointID joint = make(number % 11, first, second, anchor);
        if (number % 5 == 0) addFeedback(joint);
    }

private:
    dJointID make(int type, dBodyID first, dBodyID second, Vector3 anchor) {
        switch (type) {
            case 0:
                return addBall(first, second, anchor);
            case 1:
                return addHinge(first, second, anchor, scenes::kAxisY);
            case 2:
                return addUniversal(first, second, anchor, scenes::kAxisX, scenes::kAxisY);
            case 3:
                return addHinge2(first, second, anchor, scenes::kAxisZ, scenes::kAxisX);
            default:
                return makeRare(type, first, second, anchor);
        }
    }

    dJointID makeRare(int type, dBodyID first, dBodyID second, Vector3 anchor) {
        constexpr dJointID (*create[])(dWorldID, dJointGroupID) = {
            dJointCreateSlider, dJointCreateFixed, dJointCreatePR,    dJointCreatePU,
            dJointCreatePiston, dJointCreateDBall, dJointCreateDHinge};
        const dJointID joint = add(create[type - 4](world(), nullptr));
        dJointAttach(joint, first, second);
        switch (dJointGetType(joint)) {
            case dJointTypeFixed:
                dJointSetFixed(joint);
                break;
            case dJointTypeSlider:
                dJointSetSliderAxis(joint, 0, 0, 1);
                break;
            case dJointTypePR:
                dJointSetPRAnchor(joint, anchor.x, anchor.y, anchor.z);
                dJointSetPRAxis1(joint, 0, 0, 1);
                dJointSetPRAxis2(joint, 0, 1, 0);
                break;
            case dJointTypePU:
                dJointSetPUAnchor(joint, anchor.x, anchor.y, anchor.z);
                dJointSetPUAxis1(joint, 0, 1, 0);
                dJointSetPUAxis2(joint, 1, 0, 0);
                dJointSetPUAxisP(joint, 0, 0, 1);
                break;
            case dJointTypePiston:
                dJointSetPistonAnchor(joint, anchor.x, anchor.y, anchor.z);
                dJointSetPistonAxis(joint, 0, 0, 1);
                break;
            case dJointTypeDBall:
                dJointSetDBallAnchor1(joint, anchor.x, anchor.y, anchor.z + dReal(0.1));
                dJointSetDBallAnchor2(joint, anchor.x, anchor.y, anchor.z - dReal(0.1));
                break;
            default:
                dJointSetDHingeAnchor1(joint, anchor.x, anchor.y, anchor.z + dReal(0.1));
                dJointSetDHingeAnchor2(joint, anchor.x, anchor.y, anchor.z - dReal(0.1));
                dJointSetDHingeAxis(joint, 0, 1, 0);
        }
        return joint;
    }
};

// Ball joints with motors about three axes, and weak motors along axes between bodies that nothing else
// joins.
class Motors : public JointLattice {
public:
    explicit Motors(Stepper stepper) : JointLattice(stepper, 16) { build(); }

    void control() override {
        const dReal speed = frameNumber() % 3 == 0 ? -6 : 2;
        for (std::size_t i = 0; i < m_angular.size(); ++i) {
            dJointSetAMotorParam(m_angular[i], dParamVel + dParamGroup * (i % 3), speed);
            dJointSetAMotorParam(m_angular[i], dParamFMax + dParamGroup * (i % 3), m_dice.between(0, 3));
        }
        for (const dJointID motor : m_linear) dJointSetLMotorParam(motor, dParamVel, -speed);
    }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        if (number % 4 == 3) {
            m_linear.push_back(addLinearMotor(first, second));
            return;
        }
        addBall(first, second, anchor);
        if (number % 2 == 0) m_angular.push_back(addAngularMotor(number, first, second));
    }

private:
    dJointID addAngularMotor(int number, dBodyID first, dBodyID second) {
        const bool byUser = number % 4 == 0;
        if (!byUser) return addEulerMotor(first, second, scenes::kAxisX, scenes::kAxisZ);
        const dJointID motor = add(dJointCreateAMotor(world(), nullptr));
        dJointAttach(motor, first, second);
        dJointSetAMotorMode(motor, dAMotorUser);
        dJointSetAMotorNumAxes(motor, 3);
        dJointSetAMotorAxis(motor, 0, 1, 1, 0, 0);
        dJointSetAMotorAxis(motor, 1, 2, 0, 1, 0);
        dJointSetAMotorAxis(motor, 2, 0, 0, 0, 1);
        return motor;
    }

    dJointID addLinearMotor(dBodyID first, dBodyID second) {
        const dJointID motor = add(dJointCreateLMotor(world(), nullptr));
        dJointAttach(motor, first, second);
        dJointSetLMotorNumAxes(motor, 2);
        dJointSetLMotorAxis(motor, 0, 1, 1, 0, 0);
        dJointSetLMotorAxis(motor, 1, 0, 0, 0.6, 0.8);
        dJointSetLMotorParam(motor, dParamFMax, 4);
        dJointSetLMotorParam(motor, dParamFMax2, 0.5);
        return motor;
    }

    std::vector<dJointID> m_angular, m_linear;
};

// Hinges and sliders between stops so narrow that they meet one or the other in nearly every frame, with
// motors behind.
class Stops : public JointLattice {
public:
    explicit Stops(Stepper stepper) : JointLattice(stepper) {
        build();
        for (const dBodyID knot : knots()) {
            const Vector3 speed = m_dice.within(3);
            dBodySetLinearVel(knot, speed.x, speed.y, speed.z);
            dBodySetAngularVel(knot, speed.y, speed.z, speed.x);
        }
    }

    void control() override {
        const dReal angle = dReal(2.2) * frameNumber();
        dWorldSetGravity(world(), 50 * std::cos(angle), 0, 50 * std::sin(angle));
    }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        if (number % 3 == 0) {
            const dJointID slider = add(dJointCreateSlider(world(), nullptr));
            dJointAttach(slider, first, second);
            dJointSetSliderAxis(slider, 0, 0.6, 0.8);
            setStops(slider, dJointSetSliderParam, number);
        } else {
            const Vector3 axis = number % 2 == 0 ? scenes::kAxisX : scenes::kAxisY;
            setStops(addHinge(first, second, anchor, axis), dJointSetHingeParam, number);
        }
    }

private:
    static void setStops(dJointID joint, SetParameter set, int number) {
        set(joint, dParamLoStop, -0.002);
        set(joint, dParamHiStop, number % 7 == 0 ? -0.002 : 0.002);
        if (number % 2 == 0) set(joint, dParamBounce, 0.8);
        if (number % 5 == 0) set(joint, dParamStopCFM, 0.01);
        if (number % 4 != 0) return;
        set(joint, dParamVel, number % 8 == 0 ? 5 : -5);
        set(joint, dParamFMax, 3);
        set(joint, dParamFudgeFactor, 0.6);
    }
};

// Joints are switched off and on, moved to other bodies, destroyed and made, from frame to frame.
class Rejoined : public JointLattice {
public:
    explicit Rejoined(Stepper stepper) : JointLattice(stepper, 20) { build(); }

    void control() override {
        const std::vector<dJointID> joints = m_inventory.joints;
        for (const dJointID joint : joints) {
            if (!dJointIsEnabled(joint)) {
                dJointEnable(joint);
            } else if (m_dice.oneIn(9)) {
                dJointDisable(joint);
            }
            if (m_dice.oneIn(200)) dJointAttach(joint, anyKnot(), nullptr);
            if (m_dice.oneIn(200)) destroy(joint);
        }
        for (int i = 0; i < 6; ++i) {
            const dBodyID first = anyKnot(), second = anyKnot();
            if (first == second) continue;
            const dReal *const at = dBodyGetPosition(first);
            addBall(first, second, {at[0], at[1], at[2]});
        }
    }

protected:
    void join(int number, dBodyID first, dBodyID second, Vector3 anchor) override {
        if (number % 6 == 0) {
            addHinge(second, first, anchor, scenes::kAxisZ);
        } else {
            addBall(first, second, anchor);
        }
    }

private:
    dBodyID anyKnot() {
        return knots()[static_cast<std::size_t>(m_dice.below(static_cast<int>(knots().size())))];
    }
};

}  // namespace

void addWideLattices(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(teamScenario(std::string("wide_lattices/") + name, meaning, 10, std::move(make)));
    };
    add("every_joint", "a lattice of joints of every type", make<EveryJoint>());
    add("motors", "a lattice with weak motors that turn and push", make<Motors>());
    add("stops", "a lattice of joints between narrow stops", make<Stops>());
    add("rejoined", "joints of a lattice switched, moved, destroyed and made", make<Rejoined>());
}

}  // namespace exactness
