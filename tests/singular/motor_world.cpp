#include "motor_world.h"

#include <cmath>

namespace singular {

const char *nameOf(Push push) {
    static const char *const names[] = {"small", "huge", "nan"};
    return names[static_cast<int>(push)];
}

MotorWorld::MotorWorld(Push push, int seed)
    : m_push(push),
      m_dice(static_cast<std::uint64_t>(seed) * 7919 + static_cast<std::uint64_t>(push)),
      m_world(dWorldCreate()) {
    dWorldSetCFM(m_world, m_dice.oneIn(4) ? 1e-10 : 0);
    dWorldSetGravity(m_world, 0, 0, m_dice.oneIn(2) ? -9.81 : 0);
    const int bodyCount = 2 + m_dice.below(2), jointCount = 3 + m_dice.below(6);
    for (int i = 0; i < bodyCount; ++i) addBody();
    for (int i = 0; i < jointCount; ++i) addJoint();
}

void MotorWorld::addBody() {
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetBox(&mass, 1, m_dice.between(0.2, 1), m_dice.between(0.2, 1), m_dice.between(0.2, 1));
    dMassAdjust(&mass, m_dice.between(0.5, 2));
    dBodySetMass(body, &mass);
    const int x = m_dice.below(3), y = m_dice.below(3);
    dBodySetPosition(body, x, y, m_dice.below(3));
    if (m_dice.oneIn(3)) dBodySetLinearVel(body, m_dice.between(-1, 1), 0.5, 0);
    if (m_dice.oneIn(3)) dBodySetAngularVel(body, 0, m_dice.between(-1, 1), 0.5);
    m_bodies.push_back(body);
}

void MotorWorld::addJoint() {
    const int bodyCount = static_cast<int>(m_bodies.size());
    const dBodyID one = m_bodies[m_dice.below(bodyCount)], drawn = m_bodies[m_dice.below(bodyCount)];
    createJoint(one, m_dice.oneIn(4) || drawn == one ? nullptr : drawn);
}

dReal MotorWorld::strength() { return m_dice.oneIn(4) ? 0 : m_dice.between(0, 10); }

void MotorWorld::createJoint(dBodyID one, dBodyID other) {
    const dReal speed = m_dice.oneIn(3) ? 0 : m_dice.between(-2, 2), force = strength();
    const int kind = m_dice.below(4);
    const dJointID joint = kind == 0   ? dJointCreateAMotor(m_world, nullptr)
                           : kind == 1 ? dJointCreateLMotor(m_world, nullptr)
                           : kind == 2 ? dJointCreateHinge(m_world, nullptr)
                                       : dJointCreateSlider(m_world, nullptr);
    dJointAttach(joint, one, other);
    if (kind < 2) {
        addAxes(joint, kind == 0, other != nullptr);
    } else if (kind == 2) {
        dJointSetHingeAnchor(joint, 0, 0, 0);
        dJointSetHingeAxis(joint, 1, m_dice.below(2), 0);
        dJointSetHingeParam(joint, dParamLoStop, 0);
        dJointSetHingeParam(joint, dParamHiStop, m_dice.oneIn(2) ? 0 : 0.1);
        dJointSetHingeParam(joint, dParamFMax, force);
        dJointSetHingeParam(joint, dParamVel, speed);
    } else {
        dJointSetSliderAxis(joint, 0, 1, m_dice.below(2));
        dJointSetSliderParam(joint, dParamFMax, force);
        dJointSetSliderParam(joint, dParamVel, speed);
    }
}

void MotorWorld::addAxes(dJointID motor, bool angular, bool relative) {
    const int count = 1 + m_dice.below(3);
    angular ? dJointSetAMotorNumAxes(motor, count) : dJointSetLMotorNumAxes(motor, count);
    for (int axis = 0; axis < count; ++axis) {
        const int frame = m_dice.below(relative ? 3 : 2), group = dParamGroup * axis;
        const dReal speed = m_dice.between(-2, 2), force = strength();
        if (angular) {
            dJointSetAMotorAxis(motor, axis, frame, axis == 0, axis == 1, axis == 2);
            dJointSetAMotorParam(motor, group + dParamVel, speed);
            dJointSetAMotorParam(motor, group + dParamFMax, force);
        } else {
            dJointSetLMotorAxis(motor, axis, frame, axis == 0, axis == 1, axis == 2);
            dJointSetLMotorParam(motor, group + dParamVel, speed);
            dJointSetLMotorParam(motor, group + dParamFMax, force);
        }
    }
}

void MotorWorld::push() {
    const dBodyID body = m_bodies[m_dice.below(static_cast<int>(m_bodies.size()))];
    const dReal sign = m_dice.oneIn(2) ? -1 : 1, exponent = m_dice.between(0, 160),
                small = m_dice.between(0, 1);
    const dReal size = m_push == Push::Small  ? sign * small
                       : m_push == Push::Huge ? sign * std::pow(dReal(10), exponent)
                                              : std::copysign(std::nan(""), sign);
    const dReal aside = m_dice.oneIn(2) ? size : 0;
    m_dice.oneIn(2) ? dBodyAddTorque(body, aside, 0, size) : dBodyAddForce(body, size, aside, 0);
}

}  // namespace singular
