#include "additions.h"
#include "joint_chains.h"

namespace exactness {

namespace {

// Ball joints, each with an angular motor beside it.
class AngularMotors : public JointChains {
public:
    AngularMotors(Stepper stepper, int mode) : JointChains(stepper), m_mode(mode) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        const dJointID ball = dJointCreateBall(world(), nullptr);
        dJointAttach(ball, body, before);
        dJointSetBallAnchor(ball, anchor.x, anchor.y, anchor.z);
        addFeedback(add(ball));

        const dJointID motor = dJointCreateAMotor(world(), nullptr);
        dJointAttach(motor, body, before);
        dJointSetAMotorMode(motor, m_mode);
        if (m_mode == dAMotorEuler) {
            setEulerAxes(motor, before != nullptr);
        } else {
            setUserAxes(motor, part);
        }
        for (int axis = 0; axis < 3; ++axis) setLimits(motor, dJointSetAMotorParam, axis, part + axis, 0.4);
        return motor;
    }

    void drive(dJointID joint, int place) override {
        if (dJointGetType(joint) != dJointTypeAMotor) return;
        if (m_mode == dAMotorUser) dJointSetAMotorAngle(joint, 0, 0.01 * frameNumber());
        if (place % 3 == 0) dJointAddAMotorTorques(joint, 0.1, 0.2, -0.1);
    }

private:
    static void setEulerAxes(dJointID motor, bool twoBodies) {
        dJointSetAMotorAxis(motor, 0, 1, 0, 0, 1);
        dJointSetAMotorAxis(motor, 2, twoBodies ? 2 : 0, 1, 0, 0);
    }

    static void setUserAxes(dJointID motor, int part) {
        dJointSetAMotorNumAxes(motor, 3);
        dJointSetAMotorAxis(motor, 0, part % 3, 1, 0, 0);
        dJointSetAMotorAxis(motor, 1, 1, 0, 1, 0);
        dJointSetAMotorAxis(motor, 2, 0, 0, 0, 1);
    }

    int m_mode;
};

// Bodies held by linear motors alone.
class LinearMotors : public JointChains {
public:
    explicit LinearMotors(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3) override {
        const dJointID motor = dJointCreateLMotor(world(), nullptr);
        dJointAttach(motor, body, before);
        dJointSetLMotorNumAxes(motor, 3);
        dJointSetLMotorAxis(motor, 0, 0, 1, 0, 0);
        dJointSetLMotorAxis(motor, 1, 1, 0, 1, 0);
        dJointSetLMotorAxis(motor, 2, part % 2, 0, 0, 1);
        for (int axis = 0; axis < 3; ++axis) {
            dJointSetLMotorParam(motor, dParamVel + axis * dParamGroup, 0.5 - 0.3 * axis);
            dJointSetLMotorParam(motor, dParamFMax + axis * dParamGroup, 4 + 3 * part);
        }
        return motor;
    }
};

class PlaneJoints : public JointChains {
public:
    explicit PlaneJoints(Stepper stepper) : JointChains(stepper) { build(); }

protected:
    dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) override {
        if (before != nullptr) addFeedback(add(link(before, body, anchor)));
        const dJointID joint = dJointCreatePlane2D(world(), nullptr);
        dJointAttach(joint, body, nullptr);
        if (part % 2 == 1) {
            dJointSetPlane2DXParam(joint, dParamVel, 1);
            dJointSetPlane2DXParam(joint, dParamFMax, 5);
            dJointSetPlane2DYParam(joint, dParamVel, -1);
            dJointSetPlane2DYParam(joint, dParamFMax, 3);
            dJointSetPlane2DAngleParam(joint, dParamVel, 2);
            dJointSetPlane2DAngleParam(joint, dParamFMax, 1);
        }
        return joint;
    }

private:
    dJointID link(dBodyID before, dBodyID body, Vector3 anchor) {
        const dJointID ball = dJointCreateBall(world(), nullptr);
        dJointAttach(ball, before, body);
        dJointSetBallAnchor(ball, anchor.x, anchor.y, anchor.z);
        return ball;
    }
};

}  // namespace

void addMotorJoints(Catalogue &catalogue) {
    catalogue.push_back({"motor_joints/angular_user", "angular motors about the user's axes", 60,
                         make<AngularMotors>(static_cast<int>(dAMotorUser))});
    catalogue.push_back({"motor_joints/angular_euler", "angular motors about Euler axes", 60,
                         make<AngularMotors>(static_cast<int>(dAMotorEuler))});
    catalogue.push_back({"motor_joints/linear", "linear motors along three axes", 60, make<LinearMotors>()});
    catalogue.push_back(
        {"motor_joints/plane", "bodies kept in a plane, with its motors", 60, make<PlaneJoints>()});
}

}  // namespace exactness
