// The controller odemt-fluid: lift and drag of immersed links.
#include "small_world.h"

#include <cmath>

namespace {

using namespace small_world;

// A link of 1 kg at `pose` in a fluid of 1000 kg/m³ up to z = 0, with a step of 1 ms.
std::string inFluid(const std::string &pose, const std::string &immersed,
                    const std::string &gravity = "0 0 -10") {
    return worldWith(
        "<gravity>" + gravity +
            "</gravity><physics type=\"ode\"><max_step_size>0.001</max_step_size><ode><solver>"
            "<type>world</type></solver></ode></physics>",
        "<model name=\"m\">" + linkOf1kg("boat", pose) +
            R"(<plugin name="p" filename="odemt-fluid"><surface>0</surface><density>1000</density>
                         <immersed link="boat">)" +
            immersed + "</immersed></plugin></model>");
}

const std::string liter2 = "<size>0.1 0.1 0.2</size>";  // displaces 2 kg

TEST(Fluid, LiftsWhatIsImmersedByTheWeightOfTheFluid) {
    const auto below = load(inFluid("0 0 -1 0 0 0", liter2)), above = load(inFluid("0 0 1 0 0 0", liter2)),
               half = load(inFluid("0 0 0 0 0 0", liter2)),
               lying = load(inFluid("0 0 0.05 0 1.5707963267948966 0", liter2));
    for (const auto &scene : {below.get(), above.get(), half.get(), lying.get()}) scene->frame();
    EXPECT_NEAR(velocity(body(*below, "m::boat")).z, 0.01, 1e-9);
    EXPECT_NEAR(velocity(body(*above, "m::boat")).z, -0.01, 1e-9);
    EXPECT_NEAR(velocity(body(*half, "m::boat")).z, 0, 1e-9);
    // 0.1 m high now, and so out of the fluid.
    EXPECT_NEAR(velocity(body(*lying, "m::boat")).z, -0.01, 1e-9);
}

TEST(Fluid, LiftsAtTheCenterOfTheBox) {
    const auto scene = load(inFluid("0 0 -1 0 0 0", liter2 + "<center>0.1 0 0</center>"));
    scene->frame();
    // Torque through inertia, for 1 ms.
    EXPECT_NEAR(spin(body(*scene, "m::boat")).y, -20 * 0.1 / 0.1 * 0.001, 1e-9);
}

TEST(Fluid, DragGrowsWithTheSquareOfTheSpeedAlongEachAxis) {
    const auto scene =
        load(inFluid("0 0 -1 0 0 1.5707963267948966", liter2 + "<drag>0.5 2 0</drag>", "0 0 0"));
    const dBodyID boat = body(*scene, "m::boat");
    dBodySetLinearVel(boat, 0.4, 0, 0);  // along -y of the link, whose side is 0.02 m²
    scene->frame();
    EXPECT_NEAR(velocity(boat).x, 0.4 - 0.5 * 1000 * 2 * 0.02 * 0.4 * 0.4 * 0.001, 1e-9);
    dBodySetLinearVel(boat, 0, 0, 0.4);
    scene->frame();
    EXPECT_NEAR(velocity(boat).z, 0.4, 1e-9);
}

TEST(Fluid, DragNeverTurnsAMotionRound) {
    const auto scene =
        load(inFluid("0 0 -1 0 0 0", liter2 + "<drag>1 1 1</drag><spin_drag>1e6</spin_drag>", "0 0 0"));
    const dBodyID boat = body(*scene, "m::boat");
    dBodySetLinearVel(boat, 1000, 0, 0);
    dBodySetAngularVel(boat, 0, 0, 5);
    scene->frame();
    EXPECT_NEAR(velocity(boat).x, 0, 1e-9);
    EXPECT_NEAR(spin(boat).z, 0, 1e-9);
}

// Off the centre of mass a force meets less than the link's mass, and drag may be any.
TEST(Fluid, DragNeverAddsEnergy) {
    const auto scene = load(inFluid("0 0 -1 0 0 0", liter2 + "<center>1 0.5 0.2</center><drag>1e6 1e6 1e6</drag><spin_drag>1e6</spin_drag>",
                                    "0 0 0"));
    const dBodyID boat = body(*scene, "m::boat");
    dBodySetLinearVel(boat, 1, 2, 3);
    dBodySetAngularVel(boat, 3, 2, 1);
    const auto energy = [&] {
        const dMass mass = massOf(boat);
        const Vector3 turning = spin(boat);
        dVector3 along;
        dBodyVectorFromWorld(boat, static_cast<dReal>(turning.x), static_cast<dReal>(turning.y),
                             static_cast<dReal>(turning.z), along);
        double sum = mass.mass * velocity(boat).squaredLength();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) sum += along[i] * mass.I[4 * i + j] * along[j];
        return sum / 2;
    };
    const double first = energy();
    double last = first;
    for (int i = 0; i < 200; ++i) {
        scene->frame();
        ASSERT_LE(energy(), last * (1 + 1e-6)) << i;
        last = energy();
    }
    EXPECT_LT(last, 1e-3 * first);
}

TEST(Fluid, ParametersAreChecked) {
    const auto expect = [](const std::string &immersed, const std::string &path, const std::string &message) {
        expectError(inFluid("0 0 0 0 0 0", immersed), worlds::LoadError::Kind::Value,
                    {"test.sdf: /sdf/world/model[m]/plugin[p]" + path + ": ", message});
    };
    expect("", "/immersed", "needs an element <size>");
    expect("<size>1 1</size>", "/immersed/size", "2 numbers instead of 3");
    expect("<size>1 1 -1</size>", "/immersed/size", "negative");
    expect("<size>1 1 1</size><drag>1 -1 1</drag>", "/immersed/drag", "negative");
    expect("<size>1 1 1</size><spin_drag>-1</spin_drag>", "/immersed", "negative");
    expect("<size>1 1 1</size><sail/>", "/immersed/sail", "not known");
    expectError(inFluid("0 0 0 0 0 0", liter2 + "</immersed><immersed link=\"boat\">" + liter2),
                worlds::LoadError::Kind::Value, {"link 'boat' is pushed already"});
    expectError(inFluid("0 0 0 0 0 0", liter2 + "</immersed><immersed link=\"mast\">" + liter2),
                worlds::LoadError::Kind::Value, {"no link 'mast'"});
}

}  // namespace
