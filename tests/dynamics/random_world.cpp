#include "random_world.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace {

enum Kind : unsigned {
    kBall, kHinge, kSlider, kUniversal, kHinge2, kFixed, kAMotor, kLMotor, kPiston, kPR, kPU, kDBall, kDHinge, kPlane2D,
    kEmptyMotor, kContact, kKinds
};

void append(std::vector<std::uint64_t> &state, const dReal *numbers, int count) {
    for (int i = 0; i < count; ++i) {
        std::uint64_t bits = 0;
        if (std::isnan(numbers[i]))
            bits = ~bits;
        else
            std::memcpy(&bits, numbers + i, sizeof numbers[i]);
        state.push_back(bits);
    }
}

}  // namespace

RandomWorld::RandomWorld(const Shape &shape, unsigned seed) : m_shape(shape), m_random(seed), m_world(dWorldCreate()) {
    dWorldSetGravity(m_world, chance(3) ? dReal(0.5) : 0, 0, chance(5) ? 0 : dReal(-9.8));
    dWorldSetCFM(m_world, chance(3) ? dReal(1e-5) : dReal(1e-9));
    // Room for what the estimate says and no more: an arena that is left is an assertion.
    dWorldStepReserveInfo reserve = {sizeof reserve, 1.0f, 0};
    dWorldSetStepMemoryReservationPolicy(m_world, &reserve);
    for (unsigned i = 0; i < shape.bodies; ++i) addBody();
    for (unsigned i = 0; i < shape.joints; ++i) addJoint();
}

RandomWorld::~RandomWorld() { dWorldDestroy(m_world); }

void RandomWorld::addBody() {
    const dBodyID body = dBodyCreate(m_world);
    dMass mass;
    dMassSetBoxTotal(&mass, dReal(1 + 0.9 * number()), dReal(0.2 + 0.1 * number()), dReal(0.3), dReal(1 + 0.5 * number()));
    dBodySetMass(body, &mass);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, dReal(number()), dReal(number()), dReal(1), dReal(3 * number()));
    dBodySetRotation(body, rotation);
    dBodySetPosition(body, dReal(number()), dReal(number()), dReal(number()));
    dBodySetLinearVel(body, dReal(number()), chance(3) ? -dReal(0) : dReal(number()), dReal(number()));
    dBodySetAngularVel(body, dReal(9 * number()), dReal(9 * number()), dReal(number()));
    dBodySetGyroscopicMode(body, !chance(3));
    dBodySetGravityMode(body, !chance(5));
    if (chance(6)) dBodySetKinematic(body);
    if (!m_shape.isQuiet && chance(5)) dBodySetFiniteRotationMode(body, 1);
    if (chance(5)) dBodySetMaxAngularSpeed(body, 3);
    if (chance(5)) dBodySetDamping(body, dReal(0.1), dReal(0.2));
    m_bodies.push_back(body);
}

void RandomWorld::addJoint() {
    const unsigned kind = m_random() % (kKinds + 4);
    const bool isContact = kind >= kContact;
    const dJointID joint = isContact ? makeContact() : makeJoint(kind);
    const dBodyID first = m_bodies[m_random() % m_bodies.size()];
    dBodyID second = m_bodies[m_random() % m_bodies.size()];
    const bool isAlone = first == second || chance(4);
    if (isAlone) second = nullptr;
    const bool needsTwo = kind == kHinge2 || kind == kDHinge;
    if (needsTwo && second == nullptr) {
        dJointDestroy(joint);
        return;
    }
    if (isAlone && kind != kPlane2D && chance(2))
        dJointAttach(joint, nullptr, first);
    else
        dJointAttach(joint, first, kind == kPlane2D ? nullptr : second);
    if (!isContact) setAxes(joint, kind);
    if (chance(2)) {
        // Some joints write to one structure.
        if (m_feedbacks.empty() || !chance(4)) {
            m_feedbacks.push_back(std::make_unique<dJointFeedback>());
            std::memset(m_feedbacks.back().get(), 0, sizeof(dJointFeedback));
        }
        dJointSetFeedback(joint, m_feedbacks.back().get());
    }
    if (chance(12)) dJointDisable(joint);
    m_joints.push_back(joint);
}

dJointID RandomWorld::makeJoint(unsigned kind) {
    switch (kind) {
        case kBall: return dJointCreateBall(m_world, nullptr);
        case kHinge: return dJointCreateHinge(m_world, nullptr);
        case kSlider: return dJointCreateSlider(m_world, nullptr);
        case kUniversal: return dJointCreateUniversal(m_world, nullptr);
        case kHinge2: return dJointCreateHinge2(m_world, nullptr);
        case kFixed: return dJointCreateFixed(m_world, nullptr);
        case kLMotor: return dJointCreateLMotor(m_world, nullptr);
        case kPiston: return dJointCreatePiston(m_world, nullptr);
        case kPR: return dJointCreatePR(m_world, nullptr);
        case kPU: return dJointCreatePU(m_world, nullptr);
        case kDBall: return dJointCreateDBall(m_world, nullptr);
        case kDHinge: return dJointCreateDHinge(m_world, nullptr);
        case kPlane2D: return dJointCreatePlane2D(m_world, nullptr);
        default: return dJointCreateAMotor(m_world, nullptr);
    }
}

dJointID RandomWorld::makeContact() {
    dContact contact;
    std::memset(&contact, 0, sizeof contact);
    dSurfaceParameters &surface = contact.surface;
    surface.mu = chance(5) ? dInfinity : chance(5) ? 0 : dReal(std::fabs(number()));
    if (chance(2)) surface.mode |= dContactMu2, surface.mu2 = chance(3) ? dInfinity : dReal(0.5);
    if (chance(3)) surface.mode |= dContactApprox1;
    if (chance(4)) surface.mode |= dContactFDir1;
    if (chance(4)) surface.mode |= dContactSoftERP | dContactSoftCFM, surface.soft_erp = dReal(0.3), surface.soft_cfm = dReal(1e-4);
    if (chance(4)) surface.mode |= dContactMotion1, surface.motion1 = dReal(number());
    if (chance(4)) surface.mode |= dContactSlip1, surface.slip1 = dReal(0.01);
    if (chance(4)) surface.mode |= dContactBounce, surface.bounce = dReal(0.5);
    if (chance(4)) surface.mode |= dContactRolling, surface.rho = dReal(0.1), surface.rho2 = dReal(0.1), surface.rhoN = dReal(0.05);
    draw(contact.geom.pos);
    draw(contact.geom.normal);
    dNormalize3(contact.geom.normal);
    draw(contact.fdir1);
    dNormalize3(contact.fdir1);
    contact.geom.depth = dReal(0.01 * std::fabs(number()));
    return dJointCreateContact(m_world, nullptr, &contact);
}

// A motor, a stop, both, or none.
void RandomWorld::setLimits(dJointID joint, void (*set)(dJointID, int, dReal), int group) {
    if (chance(2)) {
        set(joint, dParamFMax + group, dReal(5 * std::fabs(number())));
        set(joint, dParamVel + group, dReal(number()));
    }
    if (chance(2)) {
        set(joint, dParamLoStop + group, chance(2) ? dReal(0.1) : dReal(-0.1));
        set(joint, dParamHiStop + group, dReal(0.2));
        set(joint, dParamFudgeFactor + group, dReal(0.5));
        set(joint, dParamStopCFM + group, dReal(1e-6));
    }
}

void RandomWorld::setAxes(dJointID joint, unsigned kind) {
    const dReal x = dReal(number()), y = dReal(number()), z = dReal(number());
    switch (kind) {
        case kBall: dJointSetBallAnchor(joint, x, y, z); break;
        case kHinge:
            dJointSetHingeAnchor(joint, x, y, z);
            dJointSetHingeAxis(joint, x, y, 1);
            setLimits(joint, dJointSetHingeParam, 0);
            break;
        case kSlider:
            dJointSetSliderAxis(joint, x, 1, z);
            setLimits(joint, dJointSetSliderParam, 0);
            break;
        case kUniversal:
            dJointSetUniversalAnchor(joint, x, y, z);
            dJointSetUniversalAxis1(joint, 1, 0, 0);
            dJointSetUniversalAxis2(joint, 0, 1, 0);
            setLimits(joint, dJointSetUniversalParam, 0);
            setLimits(joint, dJointSetUniversalParam, dParamGroup2);
            break;
        case kHinge2: {
            const dVector3 first = {0, 0, 1}, second = {0, 1, 0};
            dJointSetHinge2Anchor(joint, x, y, z);
            dJointSetHinge2Axes(joint, first, second);
            setLimits(joint, dJointSetHinge2Param, dParamGroup2);
            break;
        }
        case kFixed: dJointSetFixed(joint); break;
        case kAMotor:
            dJointSetAMotorNumAxes(joint, 1 + m_random() % 3);
            for (int axis = 0; axis < dJointGetAMotorNumAxes(joint); ++axis)
                dJointSetAMotorAxis(joint, axis, 0, axis == 0, axis == 1, axis == 2);
            setLimits(joint, dJointSetAMotorParam, 0);
            setLimits(joint, dJointSetAMotorParam, dParamGroup2);
            break;
        case kLMotor:
            dJointSetLMotorNumAxes(joint, 1);
            dJointSetLMotorAxis(joint, 0, 0, 1, 0, 0);
            setLimits(joint, dJointSetLMotorParam, 0);
            break;
        case kPiston:
            dJointSetPistonAnchor(joint, x, y, z);
            dJointSetPistonAxis(joint, 0, 0, 1);
            setLimits(joint, dJointSetPistonParam, 0);
            break;
        case kPR:
            dJointSetPRAnchor(joint, x, y, z);
            dJointSetPRAxis1(joint, 1, 0, 0);
            dJointSetPRAxis2(joint, 0, 1, 0);
            setLimits(joint, dJointSetPRParam, 0);
            break;
        case kPU:
            dJointSetPUAnchor(joint, x, y, z);
            dJointSetPUAxis1(joint, 1, 0, 0);
            dJointSetPUAxis2(joint, 0, 1, 0);
            dJointSetPUAxis3(joint, 0, 0, 1);
            setLimits(joint, dJointSetPUParam, 0);
            break;
        case kDBall:
            dJointSetDBallAnchor1(joint, x, y, z);
            dJointSetDBallAnchor2(joint, y, z, x);
            break;
        case kDHinge:
            dJointSetDHingeAxis(joint, 0, 0, 1);
            dJointSetDHingeAnchor1(joint, x, y, z);
            dJointSetDHingeAnchor2(joint, y, z, x);
            break;
        case kPlane2D:
            dJointSetPlane2DXParam(joint, dParamFMax, 3);
            dJointSetPlane2DXParam(joint, dParamVel, 1);
            break;
        default: break;  // without axes, and so without rows
    }
}

void RandomWorld::push() {
    for (const dBodyID body : m_bodies) {
        if (chance(3)) dBodyAddForce(body, dReal(9 * number()), dReal(number()), 1);
        if (chance(4)) dBodySetForce(body, -dReal(0), -dReal(0), -dReal(0));
        if (chance(3)) dBodyAddTorque(body, dReal(number()), 0, dReal(number()));
        if (!m_shape.isExtreme || !chance(12)) continue;
        const dReal forces[] = {dReal(1e30), dReal(-1e30), std::numeric_limits<dReal>::quiet_NaN(),
                                std::sqrt(std::numeric_limits<dReal>::max())};
        dBodyAddForce(body, forces[m_random() % 4], 0, 0);
    }
}

std::vector<std::uint64_t> RandomWorld::state() const {
    std::vector<std::uint64_t> state;
    for (const dBodyID body : m_bodies) {
        for (const dReal *vector : {dBodyGetPosition(body), dBodyGetLinearVel(body), dBodyGetAngularVel(body),
                                    dBodyGetForce(body), dBodyGetTorque(body)})
            append(state, vector, 3);
        append(state, dBodyGetQuaternion(body), 4);
        for (int row = 0; row < 3; ++row) append(state, dBodyGetRotation(body) + 4 * row, 3);
    }
    for (const auto &feedback : m_feedbacks)
        for (const dReal *vector : {feedback->f1, feedback->t1, feedback->f2, feedback->t2}) append(state, vector, 3);
    return state;
}
