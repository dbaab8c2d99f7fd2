#include "field_readers.h"

namespace exactness {

namespace {

void readMass(dBodyID body, const Names &, Reading &reading) {
    dMass mass;
    dBodyGetMass(body, &mass);
    reading.real(mass.mass);
    reading.reals(mass.c, 3);
    readMatrix(mass.I, reading);
}

void readRotation(dBodyID body, const Names &, Reading &reading) {
    readMatrix(dBodyGetRotation(body), reading);
}

// The order of a body's joints decides the order of rows, so contact joints are named too, by the bodies
// they join: a scene does not list them.
void readJointList(dBodyID body, const Names &names, Reading &reading) {
    const int count = dBodyGetNumJoints(body);
    for (int i = 0; i < count; ++i) {
        const dJointID joint = dBodyGetJoint(body, i);
        reading.integer(dJointGetType(joint));
        reading.integer(names.of(joint));
        reading.integer(names.of(dJointGetBody(joint, 0)));
        reading.integer(names.of(dJointGetBody(joint, 1)));
    }
}

void readGeomList(dBodyID body, const Names &names, Reading &reading) {
    for (dGeomID geom = dBodyGetFirstGeom(body); geom != nullptr; geom = dBodyGetNextGeom(geom)) {
        reading.integer(names.of(geom));
    }
}

}  // namespace

const std::vector<Field<dBodyID>> &bodyFields() {
    static const std::vector<Field<dBodyID>> fields{
        {"position", readReals<dBodyID, dBodyGetPosition, 3>},
        {"quaternion", readReals<dBodyID, dBodyGetQuaternion, 4>},
        {"rotation", readRotation},
        {"linear velocity", readReals<dBodyID, dBodyGetLinearVel, 3>},
        {"angular velocity", readReals<dBodyID, dBodyGetAngularVel, 3>},
        {"force", readReals<dBodyID, dBodyGetForce, 3>},
        {"torque", readReals<dBodyID, dBodyGetTorque, 3>},
        {"enabled", readInteger<dBodyID, dBodyIsEnabled>},
        {"kinematic", readInteger<dBodyID, dBodyIsKinematic>},
        {"joint list", readJointList},
        {"geom list", readGeomList},
        {"mass", readMass},
        {"gravity mode", readInteger<dBodyID, dBodyGetGravityMode>},
        {"gyroscopic mode", readInteger<dBodyID, dBodyGetGyroscopicMode>},
        {"finite rotation mode", readInteger<dBodyID, dBodyGetFiniteRotationMode>},
        {"finite rotation axis", copyReals<dBodyID, dBodyGetFiniteRotationAxis>},
        {"auto-disable", readInteger<dBodyID, dBodyGetAutoDisableFlag>},
        {"auto-disable steps", readInteger<dBodyID, dBodyGetAutoDisableSteps>},
        {"auto-disable time", readReal<dBodyID, dBodyGetAutoDisableTime>},
        {"auto-disable samples", readInteger<dBodyID, dBodyGetAutoDisableAverageSamplesCount>},
        {"auto-disable linear threshold", readReal<dBodyID, dBodyGetAutoDisableLinearThreshold>},
        {"auto-disable angular threshold", readReal<dBodyID, dBodyGetAutoDisableAngularThreshold>},
        {"linear damping", readReal<dBodyID, dBodyGetLinearDamping>},
        {"linear damping threshold", readReal<dBodyID, dBodyGetLinearDampingThreshold>},
        {"angular damping", readReal<dBodyID, dBodyGetAngularDamping>},
        {"angular damping threshold", readReal<dBodyID, dBodyGetAngularDampingThreshold>},
        {"max angular speed", readReal<dBodyID, dBodyGetMaxAngularSpeed>},
    };
    return fields;
}

}  // namespace exactness
