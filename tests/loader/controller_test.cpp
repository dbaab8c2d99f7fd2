// The controllers that plugins of a model name.
#include "small_world.h"

#include <cmath>
#include <random>

namespace {

using namespace small_world;

// A wheel "w" and a slider "s" on the world, and a plugin of the model.
std::string driven(const std::string &type, const std::string &inside, const std::string &dynamics = "") {
    return worldWith(
        "<gravity>0 0 0</gravity><physics type=\"ode\"><max_step_size>0.01</max_step_size><ode><solver>"
        "<type>world</type></solver></ode></physics>",
        "<model name=\"m\">" + linkOf1kg("wheel", "0 0 0 0 0 0") + linkOf1kg("slide", "0 1 0 0 0 0") + R"(
        <joint name="w" type="revolute"><parent>world</parent><child>wheel</child>
          <axis><xyz>0 0 1</xyz><limit><effort>100</effort><velocity>5</velocity></limit>)" +
            dynamics + R"(</axis></joint>
        <joint name="s" type="prismatic"><parent>world</parent><child>slide</child><axis><xyz>1 0 0</xyz></axis></joint>
        <plugin name="p" filename=")" +
            type + "\">" + inside + "</plugin></model>");
}

std::string schedule(const std::string &phases) {
    return driven("odemt-velocity-schedule", "<joints>w s</joints>" + phases);
}

// The wheel's speed after each frame.
std::vector<long> wheelSpeeds(const std::string &sdf, int frames) {
    const auto scene = load(sdf);
    std::vector<long> speeds;
    for (int i = 0; i < frames; ++i) {
        scene->frame();
        speeds.push_back(std::lround(spin(body(*scene, "m::wheel")).z));
    }
    return speeds;
}

TEST(VelocitySchedule, PlaysItsPhasesAndKeepsTheLast) {
    EXPECT_EQ(
        wheelSpeeds(schedule("<phase duration=\"0.02\">1 0</phase><phase duration=\"0.03\">2 0</phase>"), 7),
        (std::vector<long>{1, 1, 2, 2, 2, 2, 2}));
}

TEST(VelocitySchedule, RepeatsCountedNestedAndForEver) {
    const std::string one = "<phase duration=\"0.01\">1 0</phase>",
                      two = "<phase duration=\"0.01\">2 0</phase>",
                      three = "<phase duration=\"0.02\">3 0</phase>";
    EXPECT_EQ(wheelSpeeds(schedule("<repeat count=\"2\">" + one + "<repeat count=\"2\">" + two +
                                   "</repeat></repeat>" + three),
                          8),
              (std::vector<long>{1, 2, 2, 1, 2, 2, 3, 3}));
    EXPECT_EQ(wheelSpeeds(schedule(one + "<repeat>" + two + three + "</repeat>"), 9),
              (std::vector<long>{1, 2, 3, 3, 2, 3, 3, 2, 3}));
    EXPECT_EQ(wheelSpeeds(schedule("<repeat>" + one + two + "</repeat>"), 5),
              (std::vector<long>{1, 2, 1, 2, 1}));
}

TEST(VelocitySchedule, DrivesEveryJointUpToItsLimit) {
    const auto scene = load(schedule("<phase duration=\"1\">9 -3</phase>"));
    run(*scene, 10);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 5, 1e-6);
    EXPECT_NEAR(velocity(body(*scene, "m::slide")).x, -3, 1e-6);
}

TEST(VelocitySchedule, WakesItsBodies) {
    std::string sdf = schedule("<phase duration=\"2\">0 0</phase><phase duration=\"1\">1 0</phase>");
    sdf.insert(sdf.find("</physics>"), "<odemt:auto_disable><idle_time>0.5</idle_time></odemt:auto_disable>");
    const auto scene = load(sdf);
    runFor(*scene, 1.9);
    EXPECT_FALSE(dBodyIsEnabled(body(*scene, "m::wheel")));
    runFor(*scene, 0.3);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 1, 1e-6);
}

TEST(VelocitySchedule, MotorTakesThePlaceOfFriction) {
    const auto scene =
        load(driven("odemt-velocity-schedule", "<joints>w</joints><phase duration=\"1\">3</phase>",
                    "<dynamics><friction>0.001</friction></dynamics>"));
    run(*scene, 10);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 3, 1e-6);
}

std::string positions(const std::string &phases) {
    return driven("odemt-position-schedule", "<gain>10</gain><joints>w s</joints>" + phases);
}

// The wheel's and the slider's commands in the frame to come are gain · (target - position): returns the targets.
std::pair<double, double> nextTargets(worlds::SdfScene &scene) {
    const dJointID wheel = joint(scene, "m::w"), slide = joint(scene, "m::s");
    const double angle = dJointGetHingeAngle(wheel), place = dJointGetSliderPosition(slide);
    scene.frame();
    return {angle + dJointGetHingeParam(wheel, dParamVel) / 10, place + dJointGetSliderParam(slide, dParamVel) / 10};
}

TEST(PositionSchedule, HoldsAndGlides) {
    const auto scene = load(positions(R"(<hold duration="0.02">0.1 0.2</hold><glide duration="0.04">0.3 -0.2</glide>
        <hold duration="0.01">0 0</hold>)"));
    const double wheel[] = {0.1, 0.1, 0.15, 0.2, 0.25, 0.3, 0, 0}, slide[] = {0.2, 0.2, 0.1, 0, -0.1, -0.2, 0, 0};
    for (int i = 0; i < 8; ++i) {
        const auto targets = nextTargets(*scene);
        EXPECT_NEAR(targets.first, wheel[i], 1e-9) << i;
        EXPECT_NEAR(targets.second, slide[i], 1e-9) << i;
    }
}

TEST(PositionSchedule, GlidesOnceAndFromTheEndOfARoundToItsBeginning) {
    const auto once = load(positions("<glide duration=\"0.02\">0.2 0</glide>"));
    for (double target : {0.1, 0.2, 0.2, 0.2}) EXPECT_NEAR(nextTargets(*once).first, target, 1e-9);
    const auto round = load(positions(
        "<repeat><glide duration=\"0.02\">0.2 0</glide><hold duration=\"0.01\">0.4 0</hold></repeat>"));
    for (double target : {0.1, 0.2, 0.4, 0.3, 0.2, 0.4}) EXPECT_NEAR(nextTargets(*round).first, target, 1e-9);
}

TEST(PositionSchedule, SwingsFromTheStartOfThePhase) {
    const auto scene = load(positions(R"(<hold duration="0.03">0 0</hold><swing duration="0.1" frequency="5">
        <center>0.05 0</center><amplitude>0.1 0.2</amplitude><phase>0 0.25</phase><growth>0.5 1.5</growth></swing>)"));
    run(*scene, 3);
    for (int i = 0; i < 12; ++i) {
        const double phase = 2 * 3.14159265358979323846 * 5 * 0.01 * i;
        const double growth = 0.5 + std::min((i + 1) / 10.0, 1.0);
        const auto targets = nextTargets(*scene);
        EXPECT_NEAR(targets.first, 0.05 + growth * 0.1 * std::sin(phase), 1e-9) << i;
        EXPECT_NEAR(targets.second, growth * 0.2 * std::cos(phase), 1e-9) << i;
    }
}

TEST(PositionSchedule, ReachesItsTargetsNoFasterThanTheJoint) {
    const auto scene = load(positions("<hold duration=\"1\">3 0.5</hold>"));
    run(*scene, 10);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 5, 1e-6);
    runFor(*scene, 3);
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "m::w")), 3, 1e-6);
    EXPECT_NEAR(dJointGetSliderPosition(joint(*scene, "m::s")), 0.5, 1e-6);
}

TEST(RandomCycle, FollowsTheGeneratorOfTheStandard) {
    constexpr int cycle = 10, least = 2, most = 8, seed = 42;
    const std::string sdf =
        driven("odemt-random-cycle", R"(<joints>w</joints><control_step>0.02</control_step>
        <cycle>10</cycle><first_part start="3" least="2" most="8">1</first_part><second_part>2</second_part>
        <seed>42</seed>)");
    std::minstd_rand random(seed);
    std::vector<long> expected;
    for (int round = 0; round < 5; ++round) {
        const long first = round == 0 ? 3 : least + static_cast<long>(random()) % (most - least + 1);
        for (int step = 0; step < 2 * cycle; ++step) expected.push_back(step < 2 * first ? 1 : 2);
    }
    EXPECT_EQ(wheelSpeeds(sdf, 100), expected);
}

const std::string gait = R"(<gain>10</gain><start>0.5</start><frequency>2</frequency>
    <wave name="v"><constant>0.1</constant><cos>0.01</cos><sin>0.02 0.03</sin></wave>
    <swing joint="w" wave="v" phase="0.25"/><hold joint="s">0.3</hold>)";

TEST(FourierGait, HoldsAndSwings) {
    const auto scene = load(driven("odemt-fourier-gait", gait));
    runFor(*scene, 0.5);
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "m::w")), 0, 1e-9);
    runFor(*scene, 2);
    EXPECT_NEAR(dJointGetSliderPosition(joint(*scene, "m::s")), 0.3, 1e-6);

    // The command of the next frame, by the formula.
    const double angle = dJointGetHingeAngle(joint(*scene, "m::w"));
    const double phase = 2 * 3.14159265358979323846 * (2 * (2.5 - 0.5) + 0.25);
    const double target = 0.1 + 0.01 * std::cos(phase) + 0.02 * std::sin(phase) + 0.03 * std::sin(2 * phase);
    scene->frame();
    EXPECT_NEAR(dJointGetHingeParam(joint(*scene, "m::w"), dParamVel), 10 * (target - angle), 1e-9);
}

TEST(FourierGait, SpeedIsCutToTheLimit) {
    const auto scene = load(driven("odemt-fourier-gait", "<gain>10</gain><hold joint=\"w\">3</hold>"));
    runFor(*scene, 0.2);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 5, 1e-6);
}

// One link of 1 kg and 0.1 kg·m² without gravity, and forces on it.
std::string pushed(const std::string &inside) {
    return worldWith(
        "<gravity>0 0 0</gravity><physics type=\"ode\"><max_step_size>0.01</max_step_size><ode><solver>"
        "<type>world</type></solver></ode></physics>",
        "<model name=\"m\">" + linkOf1kg("hull", "0 0 0 0 0 1.5707963267948966") +
            "<plugin name=\"p\" filename=\"odemt-body-forces\">" + inside + "</plugin></model>");
}

TEST(BodyForces, PushAlongTheAxesOfTheLinkInPhases) {
    const auto scene = load(pushed("<link>hull</link><phase duration=\"1\">2 0 0 0 0 0</phase>"
                                   "<phase duration=\"1\">0 0 0 0 0 0.1</phase>"));
    const dBodyID hull = body(*scene, "m::hull");
    runFor(*scene, 1);
    EXPECT_LT((velocity(hull) - Vector3{0, 2, 0}).length(), 1e-9);  // the link's x is the world's y
    EXPECT_EQ(spin(hull).length(), 0);
    runFor(*scene, 1);
    EXPECT_LT((velocity(hull) - Vector3{0, 2, 0}).length(), 1e-9);
    EXPECT_NEAR(spin(hull).z, 1, 1e-9);
}

TEST(BodyForces, DragSlowsDownToItsBalanceWithThrust) {
    const auto scene = load(pushed("<link>hull</link><linear_drag>0 0 0 0 0 2</linear_drag>"
                                   "<quadratic_drag>0.5 1e9 0 0 0 0</quadratic_drag>"
                                   "<phase duration=\"1\">2 0 0 0 0 3</phase>"));
    const dBodyID hull = body(*scene, "m::hull");
    dBodySetLinearVel(hull, 5, 0, 0);
    scene->frame();
    EXPECT_NEAR(velocity(hull).x, 0, 1e-9);  // no drag reverses a motion
    runFor(*scene, 10);
    EXPECT_NEAR(spin(hull).z, 1.5, 1e-6);
    EXPECT_NEAR(velocity(hull).length(), 2, 0.05);  // 0.5 · 2² is the thrust; it goes where it heads
}

TEST(BodyForces, RightingMomentSwingsTheLinkUpright) {
    const auto scene = load(pushed("<link>hull</link><righting_moment>1</righting_moment>"
                                   "<linear_drag>0 0 0 0.3 0.3 0.3</linear_drag><phase duration=\"1\">0 0 0 0 0 0</phase>"));
    const dBodyID hull = body(*scene, "m::hull");
    dQuaternion tilted;
    dQFromAxisAndAngle(tilted, 1, 1, 0, 1.5);
    dBodySetQuaternion(hull, tilted);
    runFor(*scene, 0.1);
    EXPECT_NEAR(spin(hull).length(), 1 / 0.1 * 0.1, 0.2);
    runFor(*scene, 20);
    EXPECT_GT(dBodyGetRotation(hull)[10], 0.9999);
}

// A body with products of inertia is easier to turn about one axis than its moment about that axis says.
TEST(BodyForces, DragNeverAddsEnergy) {
    std::string sdf = pushed("<link>hull</link><linear_drag>0 0 0 1e3 1e3 1e3</linear_drag><phase duration=\"1\">0 0 0 0 0 0</phase>");
    const std::string round = "<ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>";
    sdf.replace(sdf.find(round), round.size(), "<ixx>1</ixx><iyy>1</iyy><izz>1.9</izz><ixy>0.9</ixy>");
    const auto scene = load(sdf);
    const dBodyID hull = body(*scene, "m::hull");
    dBodySetAngularVel(hull, 0.1, -0.1, 0.1);
    runFor(*scene, 1);
    EXPECT_LT(spin(hull).length(), 1e-6);
}

TEST(Controller, SchedulesTakeNoMoreMemoryThanTheyMay) {
    std::string links, joints, zeros;
    for (const std::string name : {"a", "b", "c", "d", "e"}) {
        links += linkOf1kg(name, "0 0 0 0 0 0") + "<joint name=\"j" + name + "\" type=\"revolute\"><parent>world</parent><child>" + name +
                 "</child><axis><xyz>0 0 1</xyz></axis></joint>";
        joints += " j" + name;
        zeros += " 0";
    }
    expectError(worldWith("", "<model name=\"m\">" + links + "<plugin name=\"p\" filename=\"odemt-velocity-schedule\"><joints>" + joints +
                                  "</joints><repeat count=\"1e6\"><phase duration=\"1\">" + zeros + "</phase></repeat></plugin></model>"),
                worlds::LoadError::Kind::Value, {"plugin[p]/repeat/phase", "makes more than 4000000 numbers"});
}

TEST(Controller, NamesMayBeNumbers) {
    std::string sdf = pushed("<link>hull</link><phase duration=\"1\">1 0 0 0 0 0</phase>");
    for (std::size_t at; (at = sdf.find("hull")) != std::string::npos;) sdf.replace(at, 4, "1e11");
    sdf.replace(sdf.find("name=\"p\""), 8, "name=\"2e11\"");
    EXPECT_NO_THROW(load(sdf));
}

TEST(BodyForces, ParametersAreChecked) {
    const auto expect = [](const std::string &inside, const std::string &path, const std::string &message) {
        expectError(pushed(inside), worlds::LoadError::Kind::Value,
                    {"test.sdf: /sdf/world/model[m]/plugin[p]" + path + ": ", message});
    };
    const std::string phase = "<phase duration=\"1\">0 0 0 0 0 0</phase>";
    expect(phase, "", "needs an element <link>");
    expect("<link/>" + phase, "/link", "names no link");
    expect("<link>nose</link>" + phase, "/link", "no link 'nose'");
    expect("<link>hull</link>", "", "has no phases");
    expect("<link>hull</link><phase duration=\"1\">1 2 3</phase>", "/phase", "3 numbers instead of 6");
    expect("<link>hull</link><linear_drag>0 0 0 0 0 -1</linear_drag>" + phase, "/linear_drag", "negative");
    expect("<link>hull</link><wind>1</wind>" + phase, "/wind", "not known");
}

TEST(PositionSchedule, CountsOnBeyondHalfATurn) {
    const auto scene = load(driven("odemt-position-schedule", "<gain>10</gain><joints>w s</joints>"
                                                              "<hold duration=\"5\">10 0</hold><hold duration=\"5\">-7 0</hold>"));
    runFor(*scene, 5);
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "m::w")), 10 - 4 * M_PI, 1e-3);
    EXPECT_NEAR(spin(body(*scene, "m::wheel")).z, 0, 1e-3);
    runFor(*scene, 5);
    EXPECT_NEAR(dJointGetHingeAngle(joint(*scene, "m::w")), -7 + 2 * M_PI, 1e-3);
}

TEST(Controller, ReachesTheSecondAxis) {
    const auto scene = load(world("<gravity>0 0 0</gravity><model name=\"m\">" +
                                  linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", "0 1 0 0 0 0") + R"(
        <joint name="j" type="revolute2"><parent>a</parent><child>b</child>
          <axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
        <plugin name="p" filename="odemt-velocity-schedule"><joints>j/axis2</joints><phase duration="1">2</phase>
        </plugin></model>)"));
    run(*scene, 20);
    EXPECT_NEAR(spin(body(*scene, "m::b")).y - spin(body(*scene, "m::a")).y, 2, 1e-3);
}

TEST(Controller, ParametersAreChecked) {
    const auto expect = [](const std::string &type, const std::string &inside, const std::string &path,
                           const std::string &message) {
        expectError(driven(type, inside), worlds::LoadError::Kind::Value,
                    {"test.sdf: /sdf/world/model[m]/plugin[p]" + path + ": ", message});
    };
    const std::string schedule = "odemt-velocity-schedule", joints = "<joints>w</joints>";
    expect(schedule, "<phase duration=\"1\">1</phase>", "", "needs an element <joints>");
    expect(schedule, "<joints>nose</joints>", "/joints", "no joint 'nose'");
    expect(schedule, "<joints/>", "/joints", "names no joints");
    expect(schedule, joints, "", "has no phases");
    expect(schedule, joints + "<phase>1</phase>", "/phase", "needs an attribute 'duration'");
    expect(schedule, joints + "<phase duration=\"long\">1</phase>", "/phase", "'long', not a number");
    expect(schedule, joints + "<phase duration=\"nan\">1</phase>", "/phase", "not a number");
    expect(schedule, joints + "<phase duration=\"-1\">1</phase>", "/phase", "less than half a step");
    expect(schedule, joints + "<phase duration=\"1\">1 2</phase>", "/phase", "2 speeds for 1 joints");
    expect(schedule, joints + "<phase duration=\"1\">fast</phase>", "/phase", "'fast'");
    expect(schedule, joints + "<phase duration=\"1\" color=\"red\">1</phase>", "/phase",
           "no attribute 'color'");
    expect(schedule, joints + "<wait/>", "/wait", "not known");
    expect(schedule, joints + "<repeat count=\"0\"><phase duration=\"1\">1</phase></repeat>", "/repeat",
           "count");
    expect(schedule, joints + "<repeat/>", "/repeat", "repeats nothing");
    expect(schedule,
           joints + "<repeat><phase duration=\"1\">1</phase></repeat><phase duration=\"1\">1</phase>",
           "/phase", "after a repeat without end");
    expect(schedule, joints + "<repeat count=\"2\"><repeat><phase duration=\"1\">1</phase></repeat></repeat>",
           "/repeat/repeat", "inside another");
    expect(
        schedule,
        joints +
            "<repeat count=\"1e6\"><repeat count=\"1e6\"><phase duration=\"1\">1</phase></repeat></repeat>",
        "/repeat/repeat/phase", "more than 1000000 phases");
    const std::string positions = "odemt-position-schedule", gain = "<gain>1</gain>";
    expect(positions, joints + "<hold duration=\"1\">1</hold>", "", "needs an element <gain>");
    expect(positions, gain + joints, "", "has no phases");
    expect(positions, gain + joints + "<hold duration=\"1\">1 2</hold>", "/hold", "2 numbers for 1 joints");
    expect(positions, gain + joints + "<phase duration=\"1\">1</phase>", "/phase", "not known");
    expect(positions, gain + joints + "<glide>1</glide>", "/glide", "needs an attribute 'duration'");
    expect(positions, gain + joints + "<swing duration=\"1\" frequency=\"1\"/>", "/swing",
           "needs an element <amplitude>");
    expect(positions,
           gain + joints + "<swing duration=\"1\" frequency=\"1\"><amplitude>1</amplitude><growth>1</growth></swing>",
           "/swing/growth", "two numbers");
    expect(positions,
           gain + joints + "<repeat><hold duration=\"1\">1</hold></repeat><glide duration=\"1\">1</glide>", "/glide",
           "after a repeat without end");
    expect("odemt-random-cycle",
           joints +
               "<first_part start=\"1\" least=\"5\" most=\"3\">1</first_part>"
               "<second_part>1</second_part><control_step>0.01</control_step><cycle>9</cycle><seed>1</seed>",
           "/first_part", "between 5 and 9");
    expect("odemt-random-cycle",
           joints +
               "<first_part start=\"1\" least=\"1\" most=\"3\">1</first_part>"
               "<second_part>1</second_part><control_step>0.01</control_step><cycle>9</cycle><seed>0</seed>",
           "/seed", "between 1 and 2147483646");
    expect("odemt-fourier-gait", "<hold joint=\"w\">1</hold>", "", "needs an element <gain>");
    expect("odemt-fourier-gait", "<gain unit=\"1\">1</gain>", "/gain", "no attribute 'unit'");
    expect("odemt-fourier-gait", "<gain>1</gain>", "", "drives no joints");
    expect("odemt-fourier-gait", "<gain>-1</gain>", "/gain", "negative");
    expect(positions, joints + "<gain>1001</gain><hold duration=\"1\">1</hold>", "/gain", "beyond the target within a step");
    expect("odemt-fourier-gait", "<gain>1</gain><start unit=\"s\">1</start>", "/start", "no attribute 'unit'");
    expect("odemt-fourier-gait", "<gain>1</gain><wave name=\"w\"><cos first=\"1\">1</cos></wave>", "/wave[w]/cos",
           "no attribute 'first'");
    expect(schedule, "<joints all=\"1\">w</joints><phase duration=\"1\">1</phase>", "/joints", "no attribute 'all'");
    expect("odemt-random-cycle",
           joints +
               "<first_part start=\"1\" least=\"1\" most=\"3\">1</first_part><second_part start=\"1\">1</second_part>"
               "<control_step>0.01</control_step><cycle>9</cycle><seed>1</seed>",
           "/second_part", "no attribute 'start'");
    expect("odemt-fourier-gait", "<gain>1</gain><swing joint=\"w\" wave=\"big\"/>", "/swing",
           "no wave 'big'");
}

}  // namespace
