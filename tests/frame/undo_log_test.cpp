// A step that was taken back and taken again is the same step.
#include "dynamics/step/islands/dxUndoLog.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "OdeSession.h"
#include "joints/contact.h"

namespace {

using Bytes = std::vector<std::byte>;

void append(Bytes &bytes, const void *from, std::size_t size) {
    const auto *begin = static_cast<const std::byte *>(from);
    bytes.insert(bytes.end(), begin, begin + size);
}

// Two bodies and a joint between them: one island.
class Pair {
public:
    explicit Pair(const std::function<dJointID(dWorldID)> &makeJoint) : m_world(dWorldCreate()) {
        dWorldSetGravity(m_world, 0.1, 0.2, -9.81);
        for (unsigned i = 0; i < 2; ++i) {
            m_bodies[i] = dBodyCreate(m_world);
            dMass mass;
            dMassSetBoxTotal(&mass, 1 + i, 1, 0.5, 0.2);
            dBodySetMass(m_bodies[i], &mass);
            dBodySetPosition(m_bodies[i], i, 0, 0);
            dBodySetAngularVel(m_bodies[i], 1, -2, 0.5 + i);
            dBodySetLinearVel(m_bodies[i], 0, i, 0);
            dBodyAddForce(m_bodies[i], 1, 2, 3);
        }
        m_joints[0] = makeJoint(m_world);
        dJointAttach(m_joints[0], m_bodies[0], m_bodies[1]);
        dJointSetFeedback(m_joints[0], &m_feedback);
    }
    ~Pair() { dWorldDestroy(m_world); }
    Pair(const Pair &) = delete;
    Pair &operator=(const Pair &) = delete;

    dxIsland island() const { return {m_bodies, m_joints, 2, 1}; }
    dJointID joint() const { return m_joints[0]; }
    dBodyID body(unsigned i) const { return m_bodies[i]; }
    dWorldID world() const { return m_world; }

    // Every byte of the bodies, the joint and its feedback.
    Bytes memory() const {
        Bytes bytes;
        for (const dxBody *body : m_bodies) append(bytes, body, sizeof *body);
        append(bytes, m_joints[0], m_joints[0]->size());
        append(bytes, &m_feedback, sizeof m_feedback);
        return bytes;
    }

    // What the user sees of the bodies.
    Bytes motion() const {
        Bytes bytes;
        for (const dBodyID body : m_bodies) {
            append(bytes, dBodyGetPosition(body), 3 * sizeof(dReal));
            append(bytes, dBodyGetQuaternion(body), 4 * sizeof(dReal));
            append(bytes, dBodyGetRotation(body), 12 * sizeof(dReal));
            for (const dReal *vector : {dBodyGetLinearVel(body), dBodyGetAngularVel(body),
                                        dBodyGetForce(body), dBodyGetTorque(body)}) {
                append(bytes, vector, 3 * sizeof(dReal));
            }
        }
        return bytes;
    }

private:
    dWorldID m_world;
    dxBody *m_bodies[2];
    dxJoint *m_joints[1];
    dJointFeedback m_feedback{};
};

template <class Set>
void motorWithStops(dJointID joint, Set set) {
    for (const int axis : {0, static_cast<int>(dParamGroup)}) {
        set(joint, dParamVel | axis, 3);
        set(joint, dParamFMax | axis, 5);
        set(joint, dParamLoStop | axis, -0.01);
        set(joint, dParamHiStop | axis, 0.01);
        set(joint, dParamBounce | axis, 0.3);
    }
}

dJointID transmission(dWorldID world, int mode) {
    const dJointID joint = dJointCreateTransmission(world, nullptr);
    dJointSetTransmissionMode(joint, mode);
    return joint;
}

using Make = dJointID (*)(dWorldID);

const std::map<std::string, Make> kJoints = {
    {"ball", [](dWorldID w) { return dJointCreateBall(w, nullptr); }},
    {"hinge", [](dWorldID w) { return dJointCreateHinge(w, nullptr); }},
    {"slider", [](dWorldID w) { return dJointCreateSlider(w, nullptr); }},
    {"universal", [](dWorldID w) { return dJointCreateUniversal(w, nullptr); }},
    {"hinge2", [](dWorldID w) { return dJointCreateHinge2(w, nullptr); }},
    {"pr", [](dWorldID w) { return dJointCreatePR(w, nullptr); }},
    {"pu", [](dWorldID w) { return dJointCreatePU(w, nullptr); }},
    {"piston", [](dWorldID w) { return dJointCreatePiston(w, nullptr); }},
    {"fixed", [](dWorldID w) { return dJointCreateFixed(w, nullptr); }},
    {"amotor", [](dWorldID w) { return dJointCreateAMotor(w, nullptr); }},
    {"lmotor", [](dWorldID w) { return dJointCreateLMotor(w, nullptr); }},
    {"dball", [](dWorldID w) { return dJointCreateDBall(w, nullptr); }},
    {"dhinge", [](dWorldID w) { return dJointCreateDHinge(w, nullptr); }},
    {"gears", [](dWorldID w) { return transmission(w, dTransmissionParallelAxes); }},
    {"bevelgears", [](dWorldID w) { return transmission(w, dTransmissionIntersectingAxes); }},
    {"belt", [](dWorldID w) { return transmission(w, dTransmissionChainDrive); }},
};

// Makes the joint do something: anchors, axes, motors at their stops.
void setUp(const Pair &pair) {
    const dJointID j = pair.joint();
    switch (dJointGetType(j)) {
        case dJointTypeBall:
            dJointSetBallAnchor(j, 0.4, 0.1, 0);
            break;
        case dJointTypeHinge:
            dJointSetHingeAnchor(j, 0.4, 0.1, 0);
            dJointSetHingeAxis(j, 0, 1, 0.5);
            motorWithStops(j, dJointSetHingeParam);
            break;
        case dJointTypeSlider:
            dJointSetSliderAxis(j, 0, 1, 0.5);
            motorWithStops(j, dJointSetSliderParam);
            break;
        case dJointTypeUniversal:
            motorWithStops(j, dJointSetUniversalParam);
            break;
        case dJointTypeHinge2: {
            const dVector3 axis1{0, 0, 1}, axis2{0, 1, 0};
            dJointSetHinge2Axes(j, axis1, axis2);
            motorWithStops(j, dJointSetHinge2Param);
            break;
        }
        case dJointTypePR:
            motorWithStops(j, dJointSetPRParam);
            break;
        case dJointTypePU:
            motorWithStops(j, dJointSetPUParam);
            break;
        case dJointTypePiston:
            motorWithStops(j, dJointSetPistonParam);
            break;
        case dJointTypeFixed:
            dJointSetFixed(j);
            break;
        case dJointTypeAMotor:
            dJointSetAMotorNumAxes(j, 3);
            dJointSetAMotorMode(j, dAMotorEuler);
            dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
            dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
            motorWithStops(j, dJointSetAMotorParam);
            break;
        case dJointTypeLMotor:
            dJointSetLMotorNumAxes(j, 2);
            dJointSetLMotorAxis(j, 0, 1, 1, 0, 0);
            dJointSetLMotorAxis(j, 1, 2, 0, 1, 0);
            motorWithStops(j, dJointSetLMotorParam);
            break;
        case dJointTypeDBall:
            dJointSetDBallAnchor1(j, 0, 0.1, 0);
            dJointSetDBallAnchor2(j, 1, 0, 0.2);
            break;
        case dJointTypeDHinge:
            dJointSetDHingeAxis(j, 0, 1, 0);
            dJointSetDHingeAnchor1(j, 0, 0.1, 0);
            dJointSetDHingeAnchor2(j, 1, 0, 0.2);
            break;
        case dJointTypeTransmission:
            dJointSetTransmissionAnchor1(j, 0, 0, 0);
            dJointSetTransmissionAnchor2(j, 1, 1, 0);
            if (dJointGetTransmissionMode(j) == dTransmissionIntersectingAxes) {
                dJointSetTransmissionAxis1(j, 1, 0, 0);
                dJointSetTransmissionAxis2(j, 0, 1, 0);
            } else {
                dJointSetTransmissionAxis(j, 0, 1, 0);
            }
            if (dJointGetTransmissionMode(j) == dTransmissionChainDrive) {
                dJointSetTransmissionRadius1(j, 0.5);
                dJointSetTransmissionRadius2(j, 0.4);
            }
            break;
        default:
            break;
    }
}

struct Stepper {
    const char *name;
    dWorldStepFunction *step;
};
void PrintTo(const Stepper &stepper, std::ostream *out) { *out << stepper.name; }

class UndoLog : public testing::TestWithParam<std::tuple<std::string, Stepper>> {
    OdeSession session;
};

TEST_P(UndoLog, StepTakenBackAndAgainIsTheSame) {
    const auto &[joint, stepper] = GetParam();
    Pair pair(kJoints.at(joint));
    setUp(pair);
    const auto step = [&, step = stepper.step] {
        dRandSetSeed(7);
        step(pair.world(), 0.02);
    };
    for (int i = 0; i < 20; ++i) {
        dBodyAddTorque(pair.body(0), 0.5, 0.1, 0);
        const Bytes before = pair.memory(), motion = pair.motion();
        dxUndoLog log;
        log.save(pair.island());
        step();
        const Bytes after = pair.memory();
        ASSERT_NE(before, after);
        log.restore(0, log.mark());
        ASSERT_EQ(pair.motion(), motion);
        step();
        ASSERT_EQ(pair.memory(), after) << "step " << i;
    }
}

std::vector<std::string> jointNames() {
    std::vector<std::string> names;
    for (const auto &entry : kJoints) names.push_back(entry.first);
    return names;
}

INSTANTIATE_TEST_SUITE_P(
    Joints, UndoLog,
    testing::Combine(testing::ValuesIn(jointNames()),
                     testing::Values(Stepper{"world", dWorldStep}, Stepper{"quick", dWorldQuickStep})),
    [](const auto &info) { return std::get<0>(info.param) + "_" + std::get<1>(info.param).name; });

TEST(UndoLogRanges, RestoreOnlyTheirOwnIsland) {
    const OdeSession session;
    Pair first(kJoints.at("ball")), second(kJoints.at("ball"));
    dxUndoLog log;
    log.save(first.island());
    const dxUndoLog::Mark between = log.mark();
    log.save(second.island());
    const auto move = [](const Pair &pair) { dBodySetPosition(pair.body(1), 5, 5, 5); };
    move(first);
    move(second);
    log.restore(between, log.mark());
    EXPECT_EQ(dBodyGetPosition(first.body(1))[0], 5);
    EXPECT_EQ(dBodyGetPosition(second.body(1))[0], 1);
    log.restore(0, between);
    EXPECT_EQ(dBodyGetPosition(first.body(1))[0], 1);
    log.clear();
    EXPECT_EQ(log.mark(), 0u);
    move(first);
    log.restore(0, log.mark());
    EXPECT_EQ(dBodyGetPosition(first.body(1))[0], 5) << "nothing is left";
}

TEST(UndoLogRanges, CoefficientsOfContactsComeBack) {
    const OdeSession session;
    for (const int mode : {0, int(dContactAxisDep), int(dContactRolling), dContactAxisDep | dContactRolling}) {
        dContact contact{};
        contact.surface.mode = mode;
        contact.surface.mu = contact.surface.mu2 = contact.surface.rho = contact.surface.rho2 = contact.surface.rhoN = -1;
        contact.geom.normal[2] = 1;
        Pair pair([&contact](dWorldID world) { return dJointCreateContact(world, nullptr, &contact); });
        const dSurfaceParameters &surface = static_cast<dxJointContact *>(pair.joint())->contact.surface;
        const auto bytes = [&surface] {
            Bytes all;
            append(all, &surface, sizeof surface);
            return all;
        };
        const Bytes before = bytes();
        dxUndoLog log;
        log.save(pair.island());
        dWorldQuickStep(pair.world(), 0.02);
        const Bytes after = bytes();
        ASSERT_NE(before, after) << "upstream corrects them";
        log.restore(0, log.mark());
        EXPECT_EQ(bytes(), before) << "mode " << mode;
        dWorldQuickStep(pair.world(), 0.02);
        EXPECT_EQ(bytes(), after) << "mode " << mode;
    }
}

TEST(UndoLogRanges, FeedbackComesBack) {
    const OdeSession session;
    Pair pair(kJoints.at("ball"));
    dJointFeedback *feedback = dJointGetFeedback(pair.joint());
    feedback->f1[0] = 4;
    feedback->t2[2] = 5;
    dxUndoLog log;
    log.save(pair.island());
    *feedback = {};
    log.restore(0, log.mark());
    EXPECT_EQ(feedback->f1[0], 4);
    EXPECT_EQ(feedback->t2[2], 5);
}

}  // namespace
