#include "ChainWorld.h"

#include "world_parts.h"

ChainWorld::ChainWorld(unsigned chains, unsigned links, dWorldStepFunction *stepper)
    : m_world(dWorldCreate()), m_stepper(stepper) {
    dWorldSetGravity(m_world, 0, 0, -9.81);
    dWorldSetQuickStepNumIterations(m_world, 20);
    for (unsigned chain = 0; chain < chains; ++chain) {
        for (unsigned link = 0; link < links; ++link) addLink(chain, link);
    }
}

void ChainWorld::addLink(unsigned chain, unsigned link) {
    const dReal x = link, y = 3.0 * chain;  // links are 1 m long, along x
    const dBodyID above = link == 0 ? nullptr : m_bodies.back();
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetBoxTotal(&mass, 1 + 0.1 * chain, 1, 0.2, 0.3);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x + 0.5, y, 0);
    dBodySetAngularVel(body, 0.1 * chain, 0.2 * link, -0.3);

    const bool hinge = link % 3 == 2;
    const dJointID joint = hinge ? dJointCreateHinge(m_world, nullptr) : dJointCreateBall(m_world, nullptr);
    dJointAttach(joint, body, above);
    if (hinge) {
        dJointSetHingeAnchor(joint, x, y, 0);
        dJointSetHingeAxis(joint, 0, 1, 0);
        dJointSetHingeParam(joint, dParamLoStop, -0.2);
        dJointSetHingeParam(joint, dParamHiStop, 0.2);
        dJointSetHingeParam(joint, dParamVel, 1);
        dJointSetHingeParam(joint, dParamFMax, 2);
    } else {
        dJointSetBallAnchor(joint, x, y, 0);
    }
    m_feedbacks.push_back({});
    dJointSetFeedback(joint, &m_feedbacks.back());
    m_bodies.push_back(body);
    m_joints.push_back(joint);
}

void ChainWorld::step(unsigned steps) {
    for (unsigned i = 0; i < steps; ++i) m_stepper(m_world, 0.01);
}

std::vector<dReal> ChainWorld::state() const {
    std::vector<dReal> numbers;
    for (const dBodyID body : m_bodies) {
        appendMotion(numbers, body);
        append(numbers, dBodyGetForce(body), 3);
        append(numbers, dBodyGetTorque(body), 3);
    }
    for (const dJointFeedback &feedback : m_feedbacks) {
        for (const dReal *vector : {feedback.f1, feedback.t1, feedback.f2, feedback.t2}) append(numbers, vector, 3);
    }
    return numbers;
}
