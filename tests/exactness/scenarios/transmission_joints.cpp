#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Pairs of wheels on axles fixed to the world, geared together. A transmission keeps the phase of its
// wheels from step to step: state that no other joint has.
class TransmissionJoints : public ManyParts {
public:
    explicit TransmissionJoints(Stepper stepper) : ManyParts(stepper) {
        addParts([this](int part, Vector3 origin) {
            for (int gear = 0; gear < 4; ++gear) addGear(part, origin + Vector3{0, dReal(3) * gear, 2});
        });
    }

    void control() override {
        const dReal torque = frameNumber() % 50 < 25 ? 2 : -2;
        for (dJointID joint : m_inventory.joints) {
            if (dJointGetType(joint) == dJointTypeHinge) dJointAddHingeTorque(joint, torque);
        }
    }

    void step() override {
        ManyParts::step();
        for (dJointID joint : m_inventory.joints) {
            if (dJointGetType(joint) == dJointTypeTransmission) noteResults(joint);
        }
    }

private:
    void addGear(int part, Vector3 position) {
        const bool crossed = part % 3 == dTransmissionIntersectingAxes;
        const Vector3 axis1{0, 0, 1}, axis2 = crossed ? Vector3{1, 0, 0} : Vector3{0, 0, 1};
        const dBodyID wheel1 = addWheel(position, axis1),
                      wheel2 = addWheel(position + Vector3{1.2, 0, 0.4}, axis2);
        const dJointID gear = add(dJointCreateTransmission(world(), nullptr));
        dJointAttach(gear, wheel1, wheel2);
        addFeedback(gear);
        dJointSetTransmissionMode(gear, part % 3);
        setAnchorsAndAxes(gear, wheel1, axis1, wheel2, axis2);
        if (part % 3 == dTransmissionParallelAxes) dJointSetTransmissionRatio(gear, 0.5 + 0.25 * part);
        if (part % 3 == dTransmissionChainDrive) {
            dJointSetTransmissionRadius1(gear, 0.3);
            dJointSetTransmissionRadius2(gear, 0.2);
        }
        if (part % 2 == 1) dJointSetTransmissionBacklash(gear, 0.05);
    }

    static void setAnchorsAndAxes(dJointID gear, dBodyID wheel1, Vector3 axis1, dBodyID wheel2,
                                  Vector3 axis2) {
        const dReal *p1 = dBodyGetPosition(wheel1), *p2 = dBodyGetPosition(wheel2);
        dJointSetTransmissionAnchor1(gear, p1[0], p1[1], p1[2]);
        dJointSetTransmissionAnchor2(gear, p2[0], p2[1], p2[2]);
        if (dJointGetTransmissionMode(gear) == dTransmissionIntersectingAxes) {
            dJointSetTransmissionAxis1(gear, axis1.x, axis1.y, axis1.z);
            dJointSetTransmissionAxis2(gear, axis2.x, axis2.y, axis2.z);
        } else {
            dJointSetTransmissionAxis(gear, axis1.x, axis1.y, axis1.z);
        }
    }

    dBodyID addWheel(Vector3 position, Vector3 axis) {
        const dBodyID wheel = addSphere(position, 0.2, 1);
        const dJointID axle = add(dJointCreateHinge(world(), nullptr));
        dJointAttach(axle, wheel, nullptr);
        dJointSetHingeAnchor(axle, position.x, position.y, position.z);
        dJointSetHingeAxis(axle, axis.x, axis.y, axis.z);
        return wheel;
    }

    void noteResults(dJointID gear) {
        note("angle 1 of a transmission", dJointGetTransmissionAngle1(gear));
        note("angle 2 of a transmission", dJointGetTransmissionAngle2(gear));
        dVector3 points[2];
        dJointGetTransmissionContactPoint1(gear, points[0]);
        dJointGetTransmissionContactPoint2(gear, points[1]);
        for (const dReal *point : points) {
            for (int i = 0; i < 3; ++i) note("contact point of a transmission", point[i]);
        }
    }
};

}  // namespace

void addTransmissionJoints(Catalogue &catalogue) {
    catalogue.push_back({"transmission_joints", "gears: parallel and crossed axes, chain drives, backlash",
                         80, make<TransmissionJoints>()});
}

}  // namespace exactness
