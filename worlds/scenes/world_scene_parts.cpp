// The add functions of WorldScene.
#include "scenes/world_scene.h"

#include <cmath>

namespace scenes {

namespace {

// Rotates by the smallest angle, so that a body whose axis is z is unchanged. (dRFromZAxis rotates it about z;
// a universal joint on it may then start with parallel axes, which ODE complains of.)
void turnZTo(dBodyID body, const Vector3 &axis) {
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, -axis.y, axis.x, 0, std::acos(axis.z));
    dBodySetRotation(body, rotation);
}

}  // namespace

dBodyID WorldScene::addBody(const Vector3 &position, const dMass &mass, dGeomID geom) {
    const dBodyID body = add(dBodyCreate(m_world));
    dBodySetMass(body, &mass);
    dBodySetPosition(body, position.x, position.y, position.z);
    dGeomSetBody(geom, body);
    add(geom);
    return body;
}

dBodyID WorldScene::addBox(const Vector3 &position, const Vector3 &sides, dReal mass) {
    dMass inertia;
    dMassSetBoxTotal(&inertia, mass, sides.x, sides.y, sides.z);
    return addBody(position, inertia, dCreateBox(m_space, sides.x, sides.y, sides.z));
}

dBodyID WorldScene::addSphere(const Vector3 &position, dReal radius, dReal mass) {
    dMass inertia;
    dMassSetSphereTotal(&inertia, mass, radius);
    return addBody(position, inertia, dCreateSphere(m_space, radius));
}

dBodyID WorldScene::addCapsule(const Vector3 &position, const Vector3 &axis, dReal radius, dReal length,
                               dReal mass) {
    dMass inertia;
    dMassSetCapsuleTotal(&inertia, mass, 3, radius, length);
    const dBodyID body = addBody(position, inertia, dCreateCapsule(m_space, radius, length));
    turnZTo(body, axis);
    return body;
}

dBodyID WorldScene::addCylinder(const Vector3 &position, const Vector3 &axis, dReal radius, dReal length,
                                dReal mass) {
    dMass inertia;
    dMassSetCylinderTotal(&inertia, mass, 3, radius, length);
    const dBodyID body = addBody(position, inertia, dCreateCylinder(m_space, radius, length));
    turnZTo(body, axis);
    return body;
}

// With the inertia of a ball as far across as the corners reach on average: near enough for solids that
// are about as long as wide.
dBodyID WorldScene::addConvex(const Vector3 &position, const std::shared_ptr<Polyhedron> &shape, dReal mass) {
    keep(shape);
    dMass inertia;
    dMassSetSphereTotal(&inertia, mass, shape->meanRadius());
    return addBody(position, inertia, shape->createGeom(m_space));
}

dGeomID WorldScene::addGround() { return add(dCreatePlane(m_space, 0, 0, 1, 0)); }

dGeomID WorldScene::addStaticBox(const Vector3 &position, const Vector3 &sides, dReal yaw) {
    const dGeomID geom = add(dCreateBox(m_space, sides.x, sides.y, sides.z));
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, 0, 1, yaw);
    dGeomSetRotation(geom, rotation);
    dGeomSetPosition(geom, position.x, position.y, position.z);
    return geom;
}

dGeomID WorldScene::addStaticSphere(const Vector3 &position, dReal radius) {
    const dGeomID geom = add(dCreateSphere(m_space, radius));
    dGeomSetPosition(geom, position.x, position.y, position.z);
    return geom;
}

dGeomID WorldScene::addStaticCapsule(const Vector3 &position, dReal radius, dReal length) {
    const dGeomID geom = add(dCreateCapsule(m_space, radius, length));
    dGeomSetPosition(geom, position.x, position.y, position.z);
    return geom;
}

dGeomID WorldScene::addStaticCylinder(const Vector3 &position, dReal radius, dReal length) {
    const dGeomID geom = add(dCreateCylinder(m_space, radius, length));
    dGeomSetPosition(geom, position.x, position.y, position.z);
    return geom;
}

void WorldScene::addWalls(dReal width, dReal bottom, dReal top) {
    const dReal thickness = REAL(0.2), outside = thickness / 2;
    const dReal middle = width / 2, middleZ = (bottom + top) / 2, height = top - bottom;
    const Vector3 alongX{width + 2 * thickness, thickness, height}, alongY{thickness, width, height};
    addStaticBox({middle, -outside, middleZ}, alongX);
    addStaticBox({middle, width + outside, middleZ}, alongX);
    addStaticBox({-outside, middle, middleZ}, alongY);
    addStaticBox({width + outside, middle, middleZ}, alongY);
}

dJointID WorldScene::addBall(dBodyID first, dBodyID second, const Vector3 &anchor) {
    const dJointID joint = add(dJointCreateBall(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetBallAnchor(joint, anchor.x, anchor.y, anchor.z);
    return joint;
}

dJointID WorldScene::addFixed(dBodyID first, dBodyID second) {
    const dJointID joint = add(dJointCreateFixed(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetFixed(joint);
    return joint;
}

dJointID WorldScene::addHinge(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis) {
    const dJointID joint = add(dJointCreateHinge(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetHingeAnchor(joint, anchor.x, anchor.y, anchor.z);
    dJointSetHingeAxis(joint, axis.x, axis.y, axis.z);
    return joint;
}

dJointID WorldScene::addUniversal(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis1,
                                  const Vector3 &axis2) {
    const dJointID joint = add(dJointCreateUniversal(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetUniversalAnchor(joint, anchor.x, anchor.y, anchor.z);
    // The second axis first: if the first becomes y while the second still is, ODE complains.
    dJointSetUniversalAxis2(joint, axis2.x, axis2.y, axis2.z);
    dJointSetUniversalAxis1(joint, axis1.x, axis1.y, axis1.z);
    return joint;
}

dJointID WorldScene::addHinge2(dBodyID first, dBodyID second, const Vector3 &anchor, const Vector3 &axis1,
                               const Vector3 &axis2) {
    const dJointID joint = add(dJointCreateHinge2(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetHinge2Anchor(joint, anchor.x, anchor.y, anchor.z);
    const dReal first3[] = {axis1.x, axis1.y, axis1.z}, second3[] = {axis2.x, axis2.y, axis2.z};
    dJointSetHinge2Axes(joint, first3, second3);
    return joint;
}

dJointID WorldScene::addEulerMotor(dBodyID first, dBodyID second, const Vector3 &axis1,
                                   const Vector3 &axis3) {
    enum Frame { Global, FirstBody, SecondBody };
    const dJointID joint = add(dJointCreateAMotor(m_world, nullptr));
    dJointAttach(joint, first, second);
    dJointSetAMotorMode(joint, dAMotorEuler);
    dJointSetAMotorAxis(joint, 0, FirstBody, axis1.x, axis1.y, axis1.z);
    dJointSetAMotorAxis(joint, 2, SecondBody, axis3.x, axis3.y, axis3.z);
    return joint;
}

dBodyID WorldScene::add(dBodyID body) {
    m_inventory.bodies.push_back(body);
    return body;
}

dGeomID WorldScene::add(dGeomID geom) {
    const bool isStatic = !dGeomGetBody(geom);
    dGeomSetCategoryBits(geom, isStatic ? kStaticCategory : kDynamicCategory);
    dGeomSetCollideBits(geom, isStatic ? ~kStaticCategory : ~0UL);
    m_inventory.geoms.push_back(geom);
    return geom;
}

dJointID WorldScene::add(dJointID joint) {
    m_inventory.joints.push_back(joint);
    return joint;
}

}  // namespace scenes
