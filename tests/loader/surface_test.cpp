// Friction, bounce and softness of contacts.
#include "small_world.h"
#include "test_folder.h"

#include <cmath>

namespace {

using namespace small_world;

std::string friction(const std::string &inside) {
    return "<surface><friction><ode>" + inside + "</ode></friction></surface>";
}

// Keeps the surface of the last contact.
class LastContact : public scenes::Observer {
public:
    void contact(const dContact &contact) override { last = contact; }
    dContact last{};
};

dContact contactOf(const std::string &sdf) {
    const auto scene = load(sdf);
    LastContact watch;
    scene->observe(&watch);
    scene->frame();
    return watch.last;
}

std::string restingBall(const std::string &surface) {
    return world(ground + model("m", "0 0 0.0999 0 0 0", sphere(0.1), surface));
}

TEST(Surface, LowFrictionSlidesAndHighFrictionHolds) {
    for (const auto &[mu, held] : {std::pair("0.1", false), std::pair("2", true)}) {
        const auto scene = load(world(ground + model("m", "0 0 0.1 0 0 0", box(0.4, 0.4, 0.2),
                                                     friction("<mu>" + std::string(mu) + "</mu>"))));
        runFor(*scene, 0.2);
        for (int i = 0; i < 500; ++i) {
            dBodyAddForce(body(*scene, "m::link"), 0.8 * 9.8, 0, 0);
            scene->frame();
        }
        // The floor's friction is SDF's default of 1: the weaker of the two counts.
        if (held)
            EXPECT_NEAR(position(body(*scene, "m::link")).x, 0, 1e-3);
        else
            EXPECT_NEAR(velocity(body(*scene, "m::link")).x, 0.7 * 9.8 * 0.5, 0.05);
    }
}

TEST(Surface, NegativeFrictionHasNoLimit) {
    const auto floor = [](const std::string &surface) {
        return "<model name=\"floor\"><static>true</static><link name=\"link\"><collision name=\"shape\"><geometry><plane/></geometry>" + surface +
               "</collision></link></model>";
    };
    const auto between = [&](const std::string &one, const std::string &other) {
        return contactOf(world(floor(friction(one)) + model("m", "0 0 0.0999 0 0 0", sphere(0.1), friction(other)))).surface;
    };
    EXPECT_EQ(between("<mu>-1</mu><mu2>-1</mu2>", "<mu>-1</mu>").mu, dInfinity);
    EXPECT_EQ(between("<mu>-1</mu>", "<mu>0.75</mu>").mu, 0.75);
    const dSurfaceParameters one = between("<mu>0.5</mu><mu2>-1</mu2>", "<mu>-1</mu>");
    EXPECT_EQ(one.mu, 0.5);
    EXPECT_EQ(one.mu2, dInfinity);
}

TEST(Surface, WeakerFrictionAndBounceCount) {
    const dContact contact = contactOf(world(
        "<model name=\"floor\"><static>true</static><link name=\"link\"><collision name=\"shape\"><geometry>"
        "<plane/></geometry><surface><friction><ode><mu>0.5</mu></ode></friction>"
        "<bounce><restitution_coefficient>0.25</restitution_coefficient><threshold>0.1</threshold></bounce>"
        "</surface></collision></link></model>" +
        model("m", "0 0 0.0999 0 0 0", sphere(0.1),
              "<surface><friction><ode><mu>0.75</mu></ode></friction><bounce><restitution_coefficient>0.125"
              "</restitution_coefficient><threshold>0.2</threshold></bounce></surface>")));
    EXPECT_EQ(contact.surface.mu, 0.5);
    EXPECT_EQ(contact.surface.bounce, 0.125);
    EXPECT_EQ(contact.surface.bounce_vel, 0.2);
    EXPECT_EQ(contact.surface.mode, dContactApprox1 | dContactBounce);
}

TEST(Surface, SecondFrictionDirectionAndSlip) {
    const dContact contact =
        contactOf(restingBall(friction("<mu>1</mu><mu2>0.5</mu2><fdir1>0 1 0.5</fdir1><slip1>0.01</slip1>")));
    EXPECT_EQ(contact.surface.mode, dContactApprox1 | dContactMu2 | dContactFDir1 | dContactSlip1);
    EXPECT_EQ(contact.surface.mu2, 0.5);
    EXPECT_EQ(contact.surface.slip1, 0.01);
    EXPECT_NEAR(contact.fdir1[1], 1, 1e-12);  // its part along the floor, at length 1
    EXPECT_NEAR(contact.fdir1[2], 0, 1e-12);
}

// A ball on an axle that is fixed to a frame; both spin by a quarter turn before the ball is asked.
std::string ballInFrame(const std::string &expressedIn) {
    return world(ground + "<model name=\"m\">" + linkOf1kg("frame", "0 0 0.0999 0 0 0") +
                 linkOf1kg("ball", "0 0 0.0999 0 0 0",
                           "<collision name=\"shape\"><geometry>" + sphere(0.1) + "</geometry>" +
                               friction("<mu>1</mu><mu2>0</mu2><fdir1" + expressedIn + ">1 0 0</fdir1>") +
                               "</collision>") +
                 "<joint name=\"j\" type=\"revolute\"><parent>frame</parent><child>ball</child><axis><xyz>0 0 1</xyz>"
                 "</axis></joint></model>");
}

TEST(Surface, FrictionDirectionTurnsWithTheLinkThatItIsExpressedIn) {
    for (const auto &[attribute, turned] : {std::pair("", "m::ball"), std::pair(" gz:expressed_in=\"frame\"", "m::frame"),
                                            std::pair(" ignition:expressed_in=\"frame\"", "m::frame")}) {
        const auto scene = load(ballInFrame(attribute));
        const dQuaternion quarter = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
        dBodySetQuaternion(body(*scene, turned), quarter);
        LastContact watch;
        scene->observe(&watch);
        scene->frame();
        EXPECT_NEAR(std::fabs(watch.last.fdir1[1]), 1, 1e-6) << attribute;
        EXPECT_NEAR(watch.last.fdir1[0], 0, 1e-6) << attribute;
    }
    expectError(ballInFrame(" gz:expressed_in=\"nose\""), worlds::LoadError::Kind::Value, {"no link 'nose'"});
}

// A static shape of any kind has been turned for good; ODE knows no rotation of a plane, and another one of a height field.
TEST(Surface, FrictionDirectionOfAStaticShapeTurnsWithIt) {
    const TestFolder folder("surface");
    const std::string image = folder.write("flat.pgm", "P5\n2 2\n255\n" + std::string(4, '\0'));
    for (const std::string &geometry :
         {std::string("<plane/>"), "<heightmap><uri>" + image + "</uri><size>4 4 1</size></heightmap>", box(4, 4, 1e-6)}) {
        const dContact contact = contactOf(world(
            "<model name=\"floor\"><static>true</static><pose>0 0 0 0 0 0.9</pose><link name=\"l\"><pose>0 0 0 0 0 0.4</pose>"
            "<collision name=\"c\"><pose>0 0 0 0 0 0.2707963267948966</pose><geometry>" +
            geometry + "</geometry>" + friction("<mu>1</mu><fdir1>1 0 0</fdir1>") + "</collision></link></model>" +
            model("m", "0.2 0.3 0.0999 0 0 0", sphere(0.1), friction("<mu>1</mu>"))));
        EXPECT_NEAR(contact.fdir1[0], 0, 1e-9) << geometry;
        EXPECT_NEAR(std::fabs(contact.fdir1[1]), 1, 1e-9) << geometry;
    }
}

TEST(Surface, FrictionDirectionAlongTheNormalIsLeftOut) {
    const dContact contact = contactOf(restingBall(friction("<mu>1</mu><fdir1>0 0 1</fdir1>")));
    EXPECT_EQ(contact.surface.mode & dContactFDir1, 0);
}

TEST(Surface, SoftnessIsSetWhereItIsWritten) {
    EXPECT_EQ(contactOf(restingBall("")).surface.mode, dContactApprox1);
    const dContact soft =
        contactOf(restingBall("<surface><contact><ode><soft_erp>0.3</soft_erp><soft_cfm>0.01</soft_cfm></"
                              "ode></contact></surface>"));
    EXPECT_EQ(soft.surface.mode, dContactApprox1 | dContactSoftERP | dContactSoftCFM);
    EXPECT_EQ(soft.surface.soft_erp, 0.3);
    EXPECT_EQ(soft.surface.soft_cfm, 0.01);
}

TEST(Surface, StiffnessHoldsAWeightAsASpringDoes) {
    const auto scene =
        load(restingBall("<surface><contact><ode><kp>1000</kp><kd>100</kd></ode></contact></surface>"));
    runFor(*scene, 3);
    EXPECT_NEAR(position(body(*scene, "m::link")).z, 0.1 - 9.8 / 1000, 1e-4);
}

TEST(Surface, BouncesAboveTheThresholdAlone) {
    const std::string ball =
        "<surface><bounce><restitution_coefficient>0.5</restitution_coefficient>"
        "<threshold>0.5</threshold></bounce></surface>";
    const std::string sdf = worldWith(
        R"(<physics type="ode"><max_step_size>0.001</max_step_size>
             <ode><solver><type>world</type></solver><constraints><contact_surface_layer>0</contact_surface_layer>
             </constraints></ode>
             <odemt:default_surface><bounce><restitution_coefficient>1</restitution_coefficient>
             <threshold>0</threshold></bounce></odemt:default_surface></physics>)",
        ground + model("m", "0 0 0.6 0 0 0", sphere(0.1), ball));
    const auto scene = load(sdf);
    double highest = 0;
    bool fallen = false;
    for (int i = 0; i < 700; ++i) {
        scene->frame();
        fallen = fallen || scene->contactCount() > 0;
        if (fallen) highest = std::max(highest, position(body(*scene, "m::link")).z);
    }
    EXPECT_NEAR(highest, 0.1 + 0.25 * 0.5, 0.01);  // half the speed, a quarter of the height
    runFor(*scene, 3);
    EXPECT_NEAR(velocity(body(*scene, "m::link")).z, 0, 1e-6);
}

TEST(Surface, MasksDecideWhoMeetsWhom) {
    const auto touches = [](const std::string &one, const std::string &other) {
        const std::string begin = "<surface><contact>", end = "</contact></surface>";
        const auto scene = load(world(model("a", "0 0 0 0 0 0", sphere(0.1), begin + one + end) +
                                      model("b", "0.1 0 0 0 0 0", sphere(0.1), begin + other + end)));
        scene->frame();
        return scene->contactCount() > 0;
    };
    const std::string one = "<collide_bitmask>1</collide_bitmask>",
                      two = "<collide_bitmask>2</collide_bitmask>";
    EXPECT_TRUE(touches(one, one));
    EXPECT_FALSE(touches(one, two));
    EXPECT_TRUE(touches(one, two + "<category_bitmask>1</category_bitmask>"));
    EXPECT_TRUE(touches(one, "<collide_bitmask>3</collide_bitmask>"));
    EXPECT_TRUE(touches(one, "<collide_bitmask>0x01</collide_bitmask>"));
    EXPECT_FALSE(touches(one, "<collide_bitmask>0xfffe</collide_bitmask>"));
    const std::string ghost = "<collide_without_contact>true</collide_without_contact>";
    EXPECT_FALSE(touches(ghost, ""));
    EXPECT_FALSE(touches("", ghost + one));
    EXPECT_TRUE(touches("<collide_without_contact>false</collide_without_contact>", ""));
}

TEST(Surface, MasksHoldAgainstStaticShapesToo) {
    const auto touches = [](const std::string &ball, const std::string &ground) {
        const auto scene = load(world(
            "<model name=\"floor\"><static>true</static><link name=\"link\"><collision "
            "name=\"shape\"><geometry>"
            "<plane/></geometry><surface><contact>" +
            ground + "</contact></surface></collision></link></model>" +
            model("m", "0 0 0.05 0 0 0", sphere(0.1), "<surface><contact>" + ball + "</contact></surface>")));
        scene->frame();
        return scene->contactCount() > 0;
    };
    const std::string one = "<collide_bitmask>1</collide_bitmask>",
                      two = "<collide_bitmask>2</collide_bitmask>";
    EXPECT_TRUE(touches(one, one));
    EXPECT_FALSE(touches(one, two));
    EXPECT_TRUE(touches(one, two + "<category_bitmask>1</category_bitmask>"));
    EXPECT_TRUE(touches(two + "<category_bitmask>1</category_bitmask>", one));
    const std::string ghost = "<collide_without_contact>true</collide_without_contact>";
    EXPECT_FALSE(touches(ghost, ""));
    EXPECT_FALSE(touches("", ghost));
}

}  // namespace
