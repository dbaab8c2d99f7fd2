#include "loader/scene/ode_body.h"

#include "loader/scene/ode_types.h"

namespace worlds {

namespace {

void setMass(dBodyID body, const Mass &source) {
    const Matrix3 &inertia = source.inertia;
    dMass mass;
    dMassSetParameters(&mass, toReal(source.mass), 0, 0, 0, toReal(inertia(0, 0)), toReal(inertia(1, 1)),
                       toReal(inertia(2, 2)), toReal(inertia(0, 1)), toReal(inertia(0, 2)),
                       toReal(inertia(1, 2)));
    dBodySetMass(body, &mass);
}

}  // namespace

dBodyID createBody(dWorldID world, const Link &link) {
    const dBodyID body = dBodyCreate(world);
    const Vector3 origin = link.pose.position + link.pose.rotation * link.mass.center;
    dBodySetPosition(body, toReal(origin.x), toReal(origin.y), toReal(origin.z));
    dBodySetQuaternion(body, OdeQuaternion(link.pose.rotation).value);
    setMass(body, link.mass);
    if (link.linearDamping) dBodySetLinearDamping(body, toReal(*link.linearDamping));
    if (link.angularDamping) dBodySetAngularDamping(body, toReal(*link.angularDamping));
    if (!link.gravity) dBodySetGravityMode(body, 0);
    if (!link.autoDisable) dBodySetAutoDisableFlag(body, 0);
    if (link.kinematic) dBodySetKinematic(body);
    return body;
}

}  // namespace worlds
