// Joints as lanes: rows of joints of all types are in the lanes of their packs, and their forces come back to feedback.
#include <gtest/gtest.h>

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "../frame/OdeSession.h"
#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/fast/dxFastQuickStepState.h"
#include "dynamics/quick_step/fast/dxJointReader.h"
#include "random_world.h"
#include "world_group.h"

namespace {

class JointReader : public testing::Test {
    const OdeSession m_session;
};

constexpr dReal kStepSize = dReal(0.01);

// A world's bodies and joints as one group, and their plan.
struct Group {
    explicit Group(dWorldID world) : group(world) {
        step.world = world;
        step.stepSize = kStepSize;
        step.fastQuickStep = &state;
        step.island = group.island();
        plan.make(step.island, arena);
    }

    const WorldGroup group;
    dxFastQuickStepState state;
    dxIslandStep step = {};
    dxStepArena arena;
    dxConstraintPlan plan;
};

void expectNear(const dxLaneNumbers &lanes, unsigned lane, dReal expected) {
    constexpr dReal kLargest = std::numeric_limits<float>::max();
    const dReal bounded = std::clamp(expected, -kLargest, kLargest);
    EXPECT_NEAR(static_cast<dReal>(lanes.lane[lane]), bounded, 1e-6 * std::max(dReal(1), std::fabs(bounded)));
}

// What a row says of A's torque, and of the sum of both.
void expectRow(const dxJointLanes &lanes, unsigned lane, const dxConstraintRow &row, bool hasSecondBody) {
    for (int axis = 0; axis < 3; ++axis) {
        const dReal linear = row.jacobian[dxConstraintRow::kBody1 + axis], onA = row.jacobian[dxConstraintRow::kBody1 + 3 + axis];
        if (hasSecondBody) EXPECT_EQ(row.jacobian[dxConstraintRow::kBody2 + axis], -linear) << "not opposite";
        expectNear(lanes.linear[axis], lane, linear);
        expectNear(lanes.angular[axis], lane, onA);
        expectNear(lanes.together[axis], lane, hasSecondBody ? onA + row.jacobian[dxConstraintRow::kBody2 + 3 + axis] : onA);
    }
    expectNear(lanes.bias, lane, kStepSize * row.jacobian[dxConstraintRow::kRhs]);
    expectNear(lanes.softness, lane, row.jacobian[dxConstraintRow::kCfm]);
    expectNear(lanes.low, lane, kStepSize * row.jacobian[dxConstraintRow::kLow]);
    expectNear(lanes.high, lane, kStepSize * row.jacobian[dxConstraintRow::kHigh]);
}

TEST_F(JointReader, WritesTheRowsOfAllTypesOfJoints) {
    std::set<dJointType> types;
    for (unsigned seed = 1; seed < 4; ++seed) {
        RandomWorld world({500, 4000}, seed);
        dWorldQuickStep(world.world(), kStepSize);  // makes what joints with motors lock
        Group group(world.world());
        std::vector<dxJointLanes> rows(group.plan.packedRows());
        unsigned count = 0;
        const unsigned found = dxJointReader(group.step, group.plan).read(rows.data());
        group.plan.forLaneJoints([&](const dxConstraintPlan::LaneJoint &own, unsigned number, unsigned lane) {
            dxJoint &joint = *group.step.island.joints[own.joint];
            types.insert(joint.type());
            dxJoint::Info1 info;
            joint.getInfo1(&info);
            dxConstraintRow expected[dxConstraintRow::kMaxOfJoint];
            dxReadJointRows(group.step, joint, 0, info.m, expected);
            const dxJointPack &pack = group.plan.jointPacks()[number];
            EXPECT_LE(info.m, pack.rowCount);
            for (unsigned k = 0; k < info.m; ++k) expectRow(rows[pack.firstRow + k], lane, expected[k], joint.node[1].body != nullptr);
            for (unsigned k = info.m; k < pack.rowCount; ++k)
                for (const dxLaneNumbers &numbers : rows[pack.firstRow + k].linear) EXPECT_EQ(numbers.lane[lane], 0);
            count += info.m;
        });
        EXPECT_EQ(found, count);
    }
    EXPECT_GE(types.size(), 14u);
}

// A net of 40 x 40 bodies, whose joints are hinges and balls.
class Net {
public:
    static constexpr unsigned kSide = 40;

    explicit Net(const char *solver, bool isFeedbackShared = false) : m_world(dWorldCreate()), m_isFeedbackShared(isFeedbackShared) {
        dWorldSetGravity(m_world, 0, 0, -10);
        dWorldSetCFM(m_world, dReal(1e-3));
        dODE_MT_SetSolver(m_world, solver);
        m_feedback.resize(2 * std::size_t(kSide) * kSide);
        for (unsigned i = 0; i < kSide * kSide; ++i) {
            addBody(i);
            if (i % kSide != 0) connect(m_bodies[i], m_bodies[i - 1]);
            if (i >= kSide) connect(m_bodies[i], m_bodies[i - kSide]);
        }
    }
    ~Net() { dWorldDestroy(m_world); }
    Net(const Net &) = delete;
    Net &operator=(const Net &) = delete;

    dWorldID world() const { return m_world; }
    const std::vector<dBodyID> &bodies() const { return m_bodies; }
    const std::vector<dJointID> &joints() const { return m_joints; }
    const std::vector<dJointFeedback> &feedback() const { return m_feedback; }

private:
    void addBody(unsigned i) {
        m_bodies.push_back(dBodyCreate(m_world));
        dMass mass;
        dMassSetBoxTotal(&mass, 1, dReal(0.6), dReal(0.4), dReal(0.5));
        dBodySetMass(m_bodies.back(), &mass);
        dBodySetPosition(m_bodies.back(), i % kSide, i / kSide, std::sin(dReal(i)));
        dBodySetLinearVel(m_bodies.back(), 0, 0, std::cos(dReal(i)));
        dBodySetAngularVel(m_bodies.back(), dReal(0.1), std::sin(dReal(3 * i)), 0);
    }

    void connect(dBodyID body, dBodyID other) {
        const dReal *const here = dBodyGetPosition(body), *const there = dBodyGetPosition(other);
        const dReal x = (here[0] + there[0]) / 2, y = (here[1] + there[1]) / 2, z = (here[2] + there[2]) / 2;
        const bool isHinge = m_joints.size() % 3 == 0;
        const dJointID joint = isHinge ? dJointCreateHinge(m_world, nullptr) : dJointCreateBall(m_world, nullptr);
        dJointAttach(joint, body, other);
        if (isHinge) {
            dJointSetHingeAnchor(joint, x, y, z);
            dJointSetHingeAxis(joint, 0, 0, 1);
        } else {
            dJointSetBallAnchor(joint, x, y, z);
        }
        dJointSetFeedback(joint, &m_feedback[m_isFeedbackShared ? m_joints.size() / 4 * 4 : m_joints.size()]);
        m_joints.push_back(joint);
    }

    const dWorldID m_world;
    const bool m_isFeedbackShared;
    std::vector<dBodyID> m_bodies;
    std::vector<dJointID> m_joints;
    std::vector<dJointFeedback> m_feedback;
};

// Forces and gravity explain how each body's velocity changes.
TEST_F(JointReader, FeedbackExplainsTheMotion) {
    Net net("fast");
    EXPECT_FALSE(Group(net.world()).plan.laneJoints().empty());
    std::vector<std::vector<double>> before, force(net.bodies().size(), {0, 0, -10});
    const auto velocitiesOf = [&] {
        std::vector<std::vector<double>> all;
        for (const dBodyID body : net.bodies()) all.emplace_back(dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
        return all;
    };
    before = velocitiesOf();
    dWorldQuickStep(net.world(), kStepSize);
    const auto after = velocitiesOf();
    const auto indexOf = [&](dBodyID body) {
        return static_cast<std::size_t>(std::find(net.bodies().begin(), net.bodies().end(), body) - net.bodies().begin());
    };
    double largest = 0;
    for (std::size_t i = 0; i < net.joints().size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            force[indexOf(dJointGetBody(net.joints()[i], 0))][axis] += net.feedback()[i].f1[axis];
            force[indexOf(dJointGetBody(net.joints()[i], 1))][axis] += net.feedback()[i].f2[axis];
            largest = std::max(largest, std::fabs(net.feedback()[i].f1[axis]));
        }
    EXPECT_GT(largest, 1);
    for (std::size_t i = 0; i < net.bodies().size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(after[i][axis] - before[i][axis], kStepSize * force[i][axis], 1e-10);
}

// Joints that share a feedback structure write it in their order, in whatever order they are solved.
TEST_F(JointReader, ASharedFeedbackIsThatOfTheLastJoint) {
    const auto lastWriters = [](const char *solver) {
        Net own(solver), shared(solver, true);
        for (const Net *net : {&own, &shared}) {
            dRandSetSeed(1);  // exact draws numbers
            dWorldQuickStep(net->world(), kStepSize);
        }
        std::vector<std::size_t> writers;
        for (std::size_t i = 0; i < own.joints().size(); ++i)
            if (own.feedback()[i].f1[2] == shared.feedback()[i / 4 * 4].f1[2]) writers.push_back(i);
        return writers;
    };
    const std::vector<std::size_t> expected = lastWriters("exact");
    EXPECT_GE(expected.size(), 2 * Net::kSide * (Net::kSide - 1) / 4u);
    EXPECT_EQ(lastWriters("fast"), expected);
}

double largestGapOf(const Net &net) {
    double largest = 0;
    for (const dJointID joint : net.joints()) {
        if (dJointGetType(joint) != dJointTypeBall) continue;
        dVector3 a, b;
        dJointGetBallAnchor(joint, a);
        dJointGetBallAnchor2(joint, b);
        double square = 0;
        for (int axis = 0; axis < 3; ++axis) square += (a[axis] - b[axis]) * (a[axis] - b[axis]);
        largest = std::max(largest, std::sqrt(square));
    }
    return largest;
}

// Two edges are held.
double largestGapAfter(int steps, const char *solver, bool isWarm) {
    Net net(solver);
    dODE_MT_SetWarmStart(net.world(), isWarm);
    for (unsigned i = 0; i < Net::kSide; ++i)
        for (const unsigned held : {i * Net::kSide, i * Net::kSide + Net::kSide - 1}) {
            const dJointID joint = dJointCreateFixed(net.world(), nullptr);
            dJointAttach(joint, net.bodies()[held], nullptr);
            dJointSetFixed(joint);
        }
    dRandSetSeed(1);
    for (int i = 0; i < steps; ++i) dWorldQuickStep(net.world(), kStepSize);
    return largestGapOf(net);
}

// With three quarters of the last step's forces joints are held better: the largest gap is less than half.
TEST_F(JointReader, BeginsWithForcesOfTheLastStep) {
    const double warm = largestGapAfter(200, "fast", true);
    EXPECT_LT(warm, 0.5 * largestGapAfter(200, "exact", true));
    EXPECT_LT(warm, 0.5 * largestGapAfter(200, "fast", false));
}

// Of a step before the last one, of other bodies, or of a step of another size there are none; nor with much over-relaxation, with which nets fly
// apart.
TEST_F(JointReader, DropsForcesThatAreNotOfTheLastStep) {
    enum Change { kNothing, kAttached, kStepBetween, kHalfStep, kOverRelaxed };
    const auto after = [](Change change, bool isWarm) {
        Net net("fast");
        dODE_MT_SetWarmStart(net.world(), isWarm);
        for (int i = 0; i < 20; ++i) dWorldQuickStep(net.world(), kStepSize);
        const auto setBack = [&net] {
            for (std::size_t i = 0; i < net.bodies().size(); ++i) {
                const dBodyID body = net.bodies()[i];
                dBodySetPosition(body, dReal(i % Net::kSide), dReal(i / Net::kSide), 0);
                const dQuaternion upright = {1, 0, 0, 0};
                dBodySetQuaternion(body, upright);
                dBodySetLinearVel(body, 0, 0, dReal(0.01) * std::cos(dReal(i)));
                dBodySetAngularVel(body, 0, 0, 0);
            }
        };
        if (change == kStepBetween) {
            for (const dJointID joint : net.joints()) dJointDisable(joint);
            dWorldQuickStep(net.world(), kStepSize);
            for (const dJointID joint : net.joints()) dJointEnable(joint);
        }
        setBack();
        if (change == kOverRelaxed) dWorldSetQuickStepW(net.world(), dReal(1.6));
        if (change == kAttached)
            for (const dJointID joint : net.joints()) dJointAttach(joint, dJointGetBody(joint, 0), dJointGetBody(joint, 1));
        dWorldQuickStep(net.world(), change == kHalfStep ? kStepSize / 2 : kStepSize);
        std::vector<dReal> velocities;
        for (const dBodyID body : net.bodies()) velocities.insert(velocities.end(), dBodyGetLinearVel(body), dBodyGetLinearVel(body) + 3);
        return velocities;
    };
    EXPECT_NE(after(kNothing, true), after(kNothing, false));
    for (const Change change : {kAttached, kStepBetween, kHalfStep, kOverRelaxed}) EXPECT_EQ(after(change, true), after(change, false)) << change;
}

// Kept forces are those of one step and one number of rows, and their marks leave the other flags alone.
TEST_F(JointReader, MarksForcesWithStepAndRows) {
    const dWorldID world = dWorldCreate();
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointDisable(joint);
    EXPECT_FALSE(dxKeptJointForces::areOf(*joint, 1, 3));
    for (const unsigned step : {1u, 77u, dxKeptJointForces::kLastStep}) {
        dxKeptJointForces::mark(*joint, step, 3);
        EXPECT_TRUE(dxKeptJointForces::areOf(*joint, step, 3));
        EXPECT_FALSE(dxKeptJointForces::areOf(*joint, step - 1, 3));
        EXPECT_FALSE(dxKeptJointForces::areOf(*joint, step, 4));
        EXPECT_FALSE(dJointIsEnabled(joint));
    }
    dxKeptJointForces::drop(*joint);
    EXPECT_FALSE(dxKeptJointForces::areOf(*joint, dxKeptJointForces::kLastStep, 3));
    dWorldDestroy(world);
}

// Where sweeps are many, and joints soft enough for them to find the solution, lanes and rows find the same velocities.
TEST_F(JointReader, FindsTheVelocitiesOfExactQuickStep) {
    Net exact("exact"), fast("fast");
    for (const Net *net : {&exact, &fast}) {
        dWorldSetQuickStepNumIterations(net->world(), 2000);
        dODE_MT_SetSolverTolerance(net->world(), 0);
        dWorldQuickStep(net->world(), kStepSize);
    }
    for (std::size_t i = 0; i < exact.bodies().size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(dBodyGetLinearVel(fast.bodies()[i])[axis], dBodyGetLinearVel(exact.bodies()[i])[axis], 1e-4);
            EXPECT_NEAR(dBodyGetAngularVel(fast.bodies()[i])[axis], dBodyGetAngularVel(exact.bodies()[i])[axis], 1e-4);
        }
}

}  // namespace
