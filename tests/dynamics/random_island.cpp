#include "random_island.h"

#include <iterator>

RandomIsland::RandomIsland(unsigned seed, unsigned bodyCount) : m_random(seed) {
    dWorldQuickStep(world, 1);  // gives the world what moving a body asks it for
    dWorldSetGravity(world, chance(20) ? number(-2, 2) : 0, 0, number(-12, 12));
    dWorldSetCFM(world, number(1e-10, 1e-4));
    dWorldSetERP(world, number(0.1, 0.9));
    dWorldSetQuickStepNumIterations(world, static_cast<int>(m_random() % 40));
    dWorldSetQuickStepW(world, number(0.9, 1.5));
    for (unsigned i = 0; i < bodyCount; ++i) addBody();
    for (unsigned i = 0; i < bodyCount; ++i) {
        const unsigned other = m_random() % bodyCount;
        addJoint(bodies[i], other == i || chance(20) ? nullptr : bodies[other]);
        if (i > 0) addJoint(bodies[i], bodies[i - 1]);
    }
}

void RandomIsland::addBody() {
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, number(0.1, 10), number(0.1, 2), number(0.1, 2), number(0.1, 2));
    dBodySetMass(body, &mass);
    dBodySetPosition(body, number(-3, 3), number(-3, 3), number(-3, 3));
    const dQuaternion turned = {number(-1, 1), number(-1, 1), number(-1, 1), number(0.1, 1)};
    dBodySetQuaternion(body, turned);
    dBodySetLinearVel(body, number(-2, 2), number(-2, 2), number(-2, 2));
    dBodySetAngularVel(body, number(-5, 5), number(-5, 5), number(-5, 5));
    dBodyAddForce(body, number(-5, 5), number(-5, 5), number(-5, 5));
    dBodyAddTorque(body, number(-5, 5), number(-5, 5), number(-5, 5));
    dBodySetGyroscopicMode(body, chance(70));
    dBodySetGravityMode(body, chance(80));
    if (chance(10)) dBodySetKinematic(body);
    if (chance(10)) dBodySetMaxAngularSpeed(body, 3);
    if (chance(20)) dBodySetFiniteRotationMode(body, 1);
    bodies.push_back(body);
}

void RandomIsland::addJoint(dBodyID body1, dBodyID body2) {
    const bool isContact = chance(50);
    const dJointID joint = isContact ? makeContact(body1, body2) : makeJoint();
    if (chance(10) && body2 == nullptr)
        dJointAttach(joint, nullptr, body1);  // reversed
    else
        dJointAttach(joint, body1, body2);
    switch (dJointGetType(joint)) {
        case dJointTypeBall: dJointSetBallAnchor(joint, number(-3, 3), number(-3, 3), 0); break;
        case dJointTypeHinge:
            dJointSetHingeAnchor(joint, number(-3, 3), number(-3, 3), 0);
            dJointSetHingeAxis(joint, number(-1, 1), number(-1, 1), 1);
            break;
        case dJointTypeSlider: dJointSetSliderAxis(joint, number(-1, 1), 1, number(-1, 1)); break;
        case dJointTypeFixed: dJointSetFixed(joint); break;
        case dJointTypeAMotor:
            dJointSetAMotorNumAxes(joint, 3);
            for (int axis = 0; axis < 3; ++axis) dJointSetAMotorAxis(joint, axis, 0, axis == 0, axis == 1, axis == 2);
            for (int axis = 0; axis < 3; ++axis) dJointSetAMotorParam(joint, dParamFMax + dParamGroup * axis, number(0, 3));
            break;
        default: break;
    }
    if (chance(25)) {
        m_feedbacks.emplace_back();
        dJointSetFeedback(joint, &m_feedbacks.back());
    }
    joints.push_back(joint);
}

dJointID RandomIsland::makeContact(dBodyID, dBodyID) {
    dContact contact = {};
    const int modes[] = {0, dContactApprox1, dContactBounce | dContactSoftERP | dContactSoftCFM, dContactMu2 | dContactFDir1 | dContactMotion1,
                         dContactRolling | dContactApprox1, dContactSlip1 | dContactSlip2};
    contact.surface.mode = modes[m_random() % std::size(modes)];
    contact.surface.mu = chance(20) ? dReal(dInfinity) : chance(20) ? 0 : number(0.1, 2);
    contact.surface.mu2 = number(0.1, 2);
    contact.surface.bounce = number(0, 1);
    contact.surface.soft_erp = number(0.1, 0.8);
    contact.surface.soft_cfm = number(1e-6, 1e-3);
    contact.surface.motion1 = number(-1, 1);
    contact.surface.slip1 = contact.surface.slip2 = number(0, 0.1);
    contact.surface.rho = number(0, 1);
    const dVector3 normal = {number(-0.4, 0.4), 0, 1};
    for (int axis = 0; axis < 3; ++axis) {
        contact.geom.pos[axis] = number(-3, 3);
        contact.geom.normal[axis] = normal[axis] / dCalcVectorLength3(normal);
    }
    contact.fdir1[1] = 1;
    contact.geom.depth = number(0, 0.1);
    return dJointCreateContact(world, nullptr, &contact);
}

// The kinds that are not contacts; one without rows, too.
dJointID RandomIsland::makeJoint() {
    switch (m_random() % 6) {
        case 0: return dJointCreateBall(world, nullptr);
        case 1: {
            const dJointID hinge = dJointCreateHinge(world, nullptr);
            dJointSetHingeParam(hinge, dParamLoStop, number(-1, -0.1));
            dJointSetHingeParam(hinge, dParamHiStop, number(0.1, 1));
            dJointSetHingeParam(hinge, dParamFMax, number(0, 4));
            dJointSetHingeParam(hinge, dParamVel, number(-2, 2));
            dJointSetHingeParam(hinge, dParamFudgeFactor, number(0.1, 1));
            return hinge;
        }
        case 2: {
            const dJointID slider = dJointCreateSlider(world, nullptr);
            dJointSetSliderParam(slider, dParamHiStop, number(-0.1, 1));
            dJointSetSliderParam(slider, dParamLoStop, number(-1, -0.1));
            dJointSetSliderParam(slider, dParamFMax, number(0, 4));
            dJointSetSliderParam(slider, dParamBounce, number(0, 1));
            return slider;
        }
        case 3: return dJointCreateFixed(world, nullptr);
        case 4: return dJointCreateAMotor(world, nullptr);
        default: return dJointCreateNull(world, nullptr);
    }
}

std::vector<dReal> RandomIsland::state() const {
    std::vector<dReal> all;
    const auto add = [&all](const dReal *numbers, int count) { all.insert(all.end(), numbers, numbers + count); };
    for (const dBodyID body : bodies) {
        add(dBodyGetPosition(body), 3);
        add(dBodyGetQuaternion(body), 4);
        add(dBodyGetLinearVel(body), 3);
        add(dBodyGetAngularVel(body), 3);
        add(dBodyGetForce(body), 3);
        add(dBodyGetTorque(body), 3);
    }
    for (const dJointFeedback &feedback : m_feedbacks)
        for (const dReal *vector : {feedback.f1, feedback.t1, feedback.f2, feedback.t2}) add(vector, 3);
    return all;
}
