// Every type of joint: what it leaves free, its stops, motors, friction, damping and springs.
#include "small_world.h"

#include "loader/scene/joint_axis.h"

#include <cmath>

namespace {

using namespace small_world;
using worlds::JointAxisHandle;

const std::string weightless = "<gravity>0 0 0</gravity>";

// Two links of 1 kg, "a" at the origin and "b" 1 m along x, and the joint "j" from a to b at b's place.
std::string pair(const std::string &type, const std::string &inside) {
    return world(weightless + "<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") +
                 linkOf1kg("b", "1 0 0 0 0 0") + "<joint name=\"j\" type=\"" + type +
                 "\"><parent>a</parent><child>b</child>" + inside + "</joint></model>");
}

// The link "b" hangs on the world.
std::string onWorld(const std::string &type, const std::string &inside,
                    const std::string &gravity = weightless) {
    return world(gravity + "<model name=\"m\">" + linkOf1kg("b", "1 0 0 0 0 0") +
                 "<joint name=\"j\" type=\"" + type + "\"><parent>world</parent><child>b</child>" + inside +
                 "</joint></model>");
}

std::string axis(const std::string &xyz, const std::string &limit = "", const std::string &dynamics = "") {
    const std::string inside = "<xyz>" + xyz + "</xyz>" +
                               (limit.empty() ? "" : "<limit>" + limit + "</limit>") +
                               (dynamics.empty() ? "" : "<dynamics>" + dynamics + "</dynamics>");
    return "<axis>" + inside + "</axis>";
}
std::string axis2(const std::string &xyz, const std::string &limit = "") {
    return "<axis2><xyz>" + xyz + "</xyz>" + (limit.empty() ? "" : "<limit>" + limit + "</limit>") +
           "</axis2>";
}
std::string motor(double force, double speed) {
    return "<physics><ode><max_force>" + std::to_string(force) + "</max_force><velocity>" +
           std::to_string(speed) + "</velocity></ode></physics>";
}

dJointID jointOf(const worlds::SdfScene &scene) { return joint(scene, "m::j"); }
Vector3 spinOfBAgainstA(const worlds::SdfScene &scene) {
    return spin(body(scene, "m::b")) - spin(body(scene, "m::a"));
}

struct TypeOfJoint {
    const char *sdf;
    std::string axes;
    dJointType ode;
};
void PrintTo(const TypeOfJoint &type, std::ostream *out) { *out << type.sdf; }

class JointType : public testing::TestWithParam<TypeOfJoint> {};

TEST_P(JointType, IsTheOneOfOdeAndHoldsTogether) {
    const auto scene = load(pair(GetParam().sdf, GetParam().axes));
    EXPECT_EQ(dJointGetType(jointOf(*scene)), GetParam().ode);
    dBodyAddForce(body(*scene, "m::b"), 10, 20, 30);
    runFor(*scene, 0.5);
    EXPECT_TRUE(isFinite(*scene));
    const Vector3 b = position(body(*scene, "m::b"));
    dVector3 seenFromA;
    dBodyGetPosRelPoint(body(*scene, "m::a"), b.x, b.y, b.z, seenFromA);
    if (GetParam().ode == dJointTypeSlider)
        EXPECT_GT(seenFromA[0], 1.001);  // has slid along x
    else
        EXPECT_NEAR(seenFromA[0], 1, 1e-4);
    EXPECT_NEAR(seenFromA[1], 0, 1e-4);
    EXPECT_NEAR(seenFromA[2], 0, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Types, JointType,
    testing::Values(TypeOfJoint{"revolute", axis("0 0 1"), dJointTypeHinge},
                    TypeOfJoint{"continuous", axis("0 0 1"), dJointTypeHinge},
                    TypeOfJoint{"prismatic", axis("1 0 0"), dJointTypeSlider},
                    TypeOfJoint{"ball", "", dJointTypeBall},
                    TypeOfJoint{"universal", axis("0 0 1") + axis2("0 1 0"), dJointTypeUniversal},
                    TypeOfJoint{"revolute2", axis("0 0 1") + axis2("0 1 0"), dJointTypeHinge2},
                    TypeOfJoint{"fixed", "", dJointTypeFixed}),
    [](const auto &info) { return info.param.sdf; });

// A motor at positive speed rotates the child against the parent, about the axis by the right-hand rule.
struct Turning {
    const char *name, *type;
    std::string axes;
    int axis;
    Vector3 direction;
};
void PrintTo(const Turning &turning, std::ostream *out) { *out << turning.name; }

class JointMotion : public testing::TestWithParam<Turning> {};

TEST_P(JointMotion, IsTheChildsAgainstTheParent) {
    const auto scene = load(pair(GetParam().type, GetParam().axes));
    const JointAxisHandle handle(jointOf(*scene), GetParam().axis);
    handle.set(dParamVel, 2);
    handle.set(dParamFMax, 100);
    run(*scene, 50);
    EXPECT_LT((spinOfBAgainstA(*scene) - 2 * GetParam().direction).length(), 0.05);
    EXPECT_NEAR(handle.rate(), 2, 0.02);
    EXPECT_NEAR(handle.position(), 2 * 0.05, 0.01);
}

TEST_P(JointMotion, IsPushedByForcesInTheSameSense) {
    const auto scene = load(pair(GetParam().type, GetParam().axes));
    const JointAxisHandle handle(jointOf(*scene), GetParam().axis);
    handle.addForce(1);
    scene->frame();
    EXPECT_GT(handle.rate(), 0);
    EXPECT_GT(spinOfBAgainstA(*scene).dot(GetParam().direction), 0);
}

class LimitedMotion : public JointMotion {};

TEST_P(LimitedMotion, StopsAtItsLimits) {
    std::string axes = GetParam().axes;
    const std::string open = GetParam().axis == 0 ? "</axis>" : "</axis2>";
    axes.insert(axes.find(open), "<limit><lower>-0.1</lower><upper>0.3</upper></limit>");
    for (const auto &[speed, stop] : {std::pair(2.0, 0.3), std::pair(-2.0, -0.1)}) {
        const auto scene = load(pair(GetParam().type, axes));
        const JointAxisHandle handle(jointOf(*scene), GetParam().axis);
        handle.set(dParamVel, speed);
        handle.set(dParamFMax, 1);
        runFor(*scene, 1);
        EXPECT_NEAR(handle.position(), stop, 0.01);
        EXPECT_NEAR(handle.rate(), 0, 0.01);
    }
}

const Turning limitedTurnings[] = {
    {"revolute", "revolute", axis("0 0 1"), 0, {0, 0, 1}},
    {"universalFirst", "universal", axis("0 0 1") + axis2("0 1 0"), 0, {0, 0, 1}},
    {"universalSecond", "universal", axis("0 0 1") + axis2("0 1 0"), 1, {0, 1, 0}},
    {"revolute2First", "revolute2", axis("0 0 1") + axis2("0 1 0"), 0, {0, 0, 1}},
};
const Turning wheelTurning{"revolute2Second", "revolute2", axis("0 0 1") + axis2("0 1 0"), 1, {0, 1, 0}};

const auto nameOfTurning = [](const testing::TestParamInfo<Turning> &info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(Axes, LimitedMotion, testing::ValuesIn(limitedTurnings), nameOfTurning);
INSTANTIATE_TEST_SUITE_P(Axes, JointMotion, testing::ValuesIn(limitedTurnings), nameOfTurning);
INSTANTIATE_TEST_SUITE_P(Wheel, JointMotion, testing::Values(wheelTurning), nameOfTurning);

TEST(Joint, PrismaticSlidesTheChildAlongTheAxisToItsLimit) {
    for (const char *parent : {"a", "world"}) {
        std::string sdf =
            pair("prismatic", axis("1 0 0", "<lower>-0.2</lower><upper>0.1</upper>") + motor(100, 1));
        sdf.replace(sdf.find("<parent>a"), 9, std::string("<parent>") + parent);
        const auto scene = load(sdf);
        run(*scene, 50);
        EXPECT_NEAR(dJointGetSliderPositionRate(jointOf(*scene)), 1, 0.02);
        const double speedOfA = velocity(body(*scene, "m::a")).x;
        EXPECT_NEAR(velocity(body(*scene, "m::b")).x - speedOfA, 1, 0.02);
        EXPECT_NEAR(dJointGetSliderPosition(jointOf(*scene)), 0.05, 0.01);
        runFor(*scene, 1);
        EXPECT_NEAR(dJointGetSliderPosition(jointOf(*scene)), 0.1, 0.01);
    }
}

TEST(Joint, TurnsOnTheWorldInTheSameSense) {
    const auto scene = load(onWorld("revolute", axis("0 0 1") + motor(100, 1)));
    run(*scene, 20);
    EXPECT_NEAR(spin(body(*scene, "m::b")).z, 1, 1e-6);
    EXPECT_GT(dJointGetHingeAngle(jointOf(*scene)), 0);
}

TEST(Joint, PendulumSwingsAsItShould) {
    // 1 kg, 1 m from its hinge: T = 2π √((m l² + I) / (m g l)).
    const auto scene = load(onWorld("revolute", "<pose>0 0 1 0 0 0</pose>" + axis("0 1 0"), ""));
    dBodySetAngularVel(body(*scene, "m::b"), 0, 0.1, 0);
    dBodySetLinearVel(body(*scene, "m::b"), -0.1, 0, 0);
    const double period = 2 * 3.14159265 * std::sqrt(1.1 / 9.8);
    runFor(*scene, period / 4);
    EXPECT_NEAR(dJointGetHingeAngleRate(jointOf(*scene)), 0, 2e-3);
    EXPECT_NEAR(dJointGetHingeAngle(jointOf(*scene)), 0.1 * period / (2 * 3.14159265), 1e-3);
}

TEST(Joint, AxisMayBeGivenInAnotherFrame) {
    const auto scene =
        load(world("<model name=\"m\"><pose>0 0 0 0 0 1.5707963267948966</pose>" +
                   linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", "1 0 0 0.3 0 0") +
                   "<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child>"
                   "<axis><xyz expressed_in=\"__model__\">1 0 0</xyz></axis></joint></model>"));
    dVector3 axis, anchor;
    dJointGetHingeAxis(jointOf(*scene), axis);
    dJointGetHingeAnchor(jointOf(*scene), anchor);
    EXPECT_NEAR(axis[1], 1, 1e-9);
    EXPECT_NEAR(anchor[1], 1, 1e-9);
}

TEST(Joint, FrictionHoldsUntilItIsOvercome) {
    for (const auto &[torque, turns] : {std::pair(0.9, false), std::pair(1.1, true)}) {
        const auto scene = load(onWorld("revolute", axis("0 0 1", "", "<friction>1</friction>")));
        for (int i = 0; i < 500; ++i) {
            dBodyAddTorque(body(*scene, "m::b"), 0, 0, torque);
            scene->frame();
        }
        EXPECT_NEAR(spin(body(*scene, "m::b")).z, turns ? 0.1 / 0.1 * 0.5 : 0, 0.02);
    }
}

TEST(Joint, DampingSlowsDown) {
    const auto scene = load(onWorld("revolute", axis("0 0 1", "", "<damping>0.2</damping>")));
    dBodySetAngularVel(body(*scene, "m::b"), 0, 0, 1);
    runFor(*scene, 1);
    EXPECT_NEAR(spin(body(*scene, "m::b")).z, std::exp(-0.2 / 0.1), 1e-3);
}

TEST(Joint, DampingBeyondWhatAStepBearsJustStops) {
    for (const char *type : {"revolute", "prismatic"}) {
        const auto scene = load(onWorld(type, axis("0 0 1", "", "<damping>1e9</damping>")));
        dBodySetAngularVel(body(*scene, "m::b"), 0, 0, 1);
        dBodySetLinearVel(body(*scene, "m::b"), 0, 0, 1);
        runFor(*scene, 0.1);
        EXPECT_TRUE(isFinite(*scene));
        EXPECT_NEAR(JointAxisHandle(jointOf(*scene), 0).rate(), 0, 1e-6);
    }
}

TEST(Joint, SpringComesToRestAtItsReference) {
    const auto scene =
        load(onWorld("prismatic", axis("0 0 1", "",
                                       "<spring_stiffness>100</spring_stiffness><spring_reference>0.2"
                                       "</spring_reference><damping>20</damping>")));
    runFor(*scene, 3);
    EXPECT_NEAR(dJointGetSliderPosition(jointOf(*scene)), 0.2, 1e-4);
}

TEST(Joint, SpringSwingsAtItsFrequency) {
    const auto scene =
        load(onWorld("prismatic", axis("0 0 1", "", "<spring_stiffness>100</spring_stiffness>")));
    dBodySetLinearVel(body(*scene, "m::b"), 0, 0, 1);
    runFor(*scene, 3.14159265 / 2 / 10);  // a quarter of the period, ω = √(100 / 1)
    EXPECT_NEAR(dJointGetSliderPosition(jointOf(*scene)), 0.1, 1e-3);
    EXPECT_NEAR(velocity(body(*scene, "m::b")).z, 0, 0.02);
}

TEST(Joint, OdeParametersArriveAtOde) {
    const auto scene = load(onWorld(
        "revolute",
        axis("0 0 1", "<lower>-1</lower><upper>2</upper>") +
            "<physics><provide_feedback>true</provide_feedback><ode><cfm>0.1</cfm><bounce>0.2</bounce>"
            "<fudge_factor>0.3</fudge_factor><limit><cfm>0.4</cfm><erp>0.5</erp></limit></ode></physics>"));
    const dJointID hinge = jointOf(*scene);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamCFM), 0.1);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamBounce), 0.2);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamFudgeFactor), 0.3);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamStopCFM), 0.4);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamStopERP), 0.5);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamLoStop), -1);
    EXPECT_DOUBLE_EQ(dJointGetHingeParam(hinge, dParamHiStop), 2);
    ASSERT_NE(dJointGetFeedback(hinge), nullptr);
}

TEST(Joint, FeedbackTellsTheForce) {
    const auto scene =
        load(onWorld("fixed", "<physics><provide_feedback>true</provide_feedback></physics>", ""));
    run(*scene, 10);
    EXPECT_NEAR(dJointGetFeedback(jointOf(*scene))->f1[2], 9.8, 1e-3);
}

TEST(Joint, SoftnessOfBallAndFixedAndSuspensionOfRevolute2) {
    const std::string soft = "<physics><ode><cfm>0.01</cfm><erp>0.7</erp></ode></physics>";
    const auto ball = load(pair("ball", soft)), fixed = load(pair("fixed", soft));
    EXPECT_DOUBLE_EQ(dJointGetBallParam(jointOf(*ball), dParamCFM), 0.01);
    EXPECT_DOUBLE_EQ(dJointGetBallParam(jointOf(*ball), dParamERP), 0.7);
    EXPECT_DOUBLE_EQ(dJointGetFixedParam(jointOf(*fixed), dParamCFM), 0.01);
    EXPECT_DOUBLE_EQ(dJointGetFixedParam(jointOf(*fixed), dParamERP), 0.7);
    const auto wheel = load(
        pair("revolute2",
             axis("0 0 1") + axis2("0 1 0") +
                 "<physics><ode><suspension><cfm>0.02</cfm><erp>0.6</erp></suspension></ode></physics>"));
    EXPECT_DOUBLE_EQ(dJointGetHinge2Param(jointOf(*wheel), dParamSuspensionCFM), 0.02);
    EXPECT_DOUBLE_EQ(dJointGetHinge2Param(jointOf(*wheel), dParamSuspensionERP), 0.6);
}

TEST(Joint, WhatCannotBeIsRefused) {
    using Kind = worlds::LoadError::Kind;
    const std::string path = "test.sdf: /sdf/world/model[m]/joint[j]";
    expectError(pair("revolute", axis("0 0 1", "<lower>1</lower><upper>-1</upper>")), Kind::Value,
                {path + "/axis", "lower limit above upper"});
    expectError(pair("revolute", axis("0 0 1", "<lower>-1</lower><upper>5</upper>")), Kind::Unsupported,
                {path + "/axis", "half a turn"});
    expectError(pair("revolute", ""), Kind::Value, {path, "needs <axis>"});
    expectError(pair("universal", axis("0 0 1")), Kind::Value, {path, "needs <axis2>"});
    expectError(pair("universal", axis("0 0 1") + axis2("0 0 1")), Kind::Value, {path, "parallel"});
    expectError(onWorld("revolute2", axis("0 0 1") + axis2("0 1 0")), Kind::Unsupported,
                {path, "static world"});
    expectError(pair("revolute2", axis("0 0 1") + axis2("0 1 0", "<lower>0</lower><upper>1</upper>")),
                Kind::Unsupported, {path + "/axis2", "second axis"});
    expectError(pair("revolute", axis("0 0 1") + "<physics><ode><erp>0.5</erp></ode></physics>"),
                Kind::Unsupported, {path + "/physics/ode/erp", "ball and fixed"});
    EXPECT_THROW(load(pair("revolute", axis("0 0 0"))), worlds::LoadError);
}

TEST(Joint, StopsBeyondAFullTurnAreNone) {
    const auto scene =
        load(onWorld("revolute", axis("0 0 1", "<lower>-6.3</lower><upper>6.3</upper>") + motor(10, 9)));
    runFor(*scene, 2);
    EXPECT_NEAR(spin(body(*scene, "m::b")).z, 9, 1e-6);
}

TEST(Joint, BetweenStaticLinksIsNone) {
    const auto scene =
        load(world("<model name=\"m\"><static>true</static>" + linkOf1kg("a", "0 0 0 0 0 0") +
                   linkOf1kg("b", "1 0 0 0 0 0") +
                   "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint></model>"));
    EXPECT_TRUE(scene->inventory().joints.empty());
}

}  // namespace
