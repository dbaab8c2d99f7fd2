// Parameters of the world.
#include "small_world.h"

#include <cmath>

namespace {

using namespace small_world;

dWorldID worldOf(const worlds::SdfScene &scene) { return scene.inventory().worlds.at(0); }

TEST(Physics, TakesEveryOdeParameter) {
    const auto scene = load(worldWith(R"(<gravity>1 2 3</gravity><physics type="ode">
        <max_step_size>0.005</max_step_size>
        <ode><solver><type>quick</type><iters>33</iters><sor>1.1</sor></solver>
        <constraints><cfm>1e-6</cfm><erp>0.4</erp><contact_max_correcting_vel>7</contact_max_correcting_vel>
        <contact_surface_layer>0.002</contact_surface_layer></constraints></ode>
      </physics>)",
                                      ""));
    const dWorldID world = worldOf(*scene);
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.005);
    EXPECT_EQ(dWorldGetQuickStepNumIterations(world), 33);
    EXPECT_DOUBLE_EQ(dWorldGetQuickStepW(world), 1.1);
    EXPECT_DOUBLE_EQ(dWorldGetCFM(world), 1e-6);
    EXPECT_DOUBLE_EQ(dWorldGetERP(world), 0.4);
    EXPECT_DOUBLE_EQ(dWorldGetContactMaxCorrectingVel(world), 7);
    EXPECT_DOUBLE_EQ(dWorldGetContactSurfaceLayer(world), 0.002);
    dVector3 gravity;
    dWorldGetGravity(world, gravity);
    EXPECT_EQ((Vector3{gravity[0], gravity[1], gravity[2]}), (Vector3{1, 2, 3}));
    EXPECT_EQ(dWorldGetAutoDisableFlag(world), 0);
}

TEST(Physics, DefaultsAreSdfs) {
    const auto scene = load(worldWith("", ""));
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.001);
    EXPECT_EQ(dWorldGetQuickStepNumIterations(worldOf(*scene)), 50);
    EXPECT_DOUBLE_EQ(dWorldGetContactMaxCorrectingVel(worldOf(*scene)), 100);
    EXPECT_DOUBLE_EQ(dWorldGetContactSurfaceLayer(worldOf(*scene)), 0.001);
}

TEST(Physics, TakesTheProfileMarkedAsDefault) {
    const std::string step = "<max_step_size>";
    const auto scene = load(worldWith("<physics name=\"a\" type=\"ode\">" + step +
                                          "0.1</max_step_size></physics><physics name=\"b\" "
                                          "default=\"true\" type=\"ode\">" +
                                          step + "0.2</max_step_size></physics>",
                                      ""));
    EXPECT_DOUBLE_EQ(scene->stepSize(), 0.2);
}

TEST(Physics, TimeIsCountedInSteps) {
    const auto scene = load(world(""));
    run(*scene, 1000);
    EXPECT_DOUBLE_EQ(scene->time(), 1);
}

// The quick stepper is inexact where the full one is not: a chain of heavy links on a light one.
TEST(Physics, SolverTypeChoosesTheStepper) {
    const auto run10 = [](const std::string &type) {
        const auto scene = load(worldWith(
            "<physics type=\"ode\"><max_step_size>0.01</max_step_size><ode><solver><type>" + type +
                "</type><iters>2</iters></solver></ode></physics>",
            "<model name=\"m\">" + linkOf1kg("a", "1 0 0 0 0 0") + linkOf1kg("b", "2 0 0 0 0 0") + R"(
              <joint name="j" type="ball"><parent>world</parent><child>a</child><pose>-1 0 0 0 0 0</pose></joint>
              <joint name="k" type="ball"><parent>a</parent><child>b</child><pose>-0.5 0 0 0 0 0</pose></joint>
            </model>)"));
        run(*scene, 10);
        return position(body(*scene, "m::b")).z;
    };
    EXPECT_NE(run10("world"), run10("quick"));
    EXPECT_DOUBLE_EQ(run10("world"), run10("world"));
    EXPECT_DOUBLE_EQ(run10("quick"), run10("quick"));
}

TEST(Physics, BodiesFallAsleepWhenTheWorldSaysSo) {
    const auto asleep = [](const std::string &autoDisable, const std::string &inModel) {
        const auto scene = load(worldWith(
            "<physics type=\"ode\"><max_step_size>0.01</max_step_size>" + autoDisable + "</physics>",
            ground + "<model name=\"m\">" + inModel + "<pose>0 0 0.1 0 0 0</pose>" +
                linkOf1kg(
                    "link", "0 0 0 0 0 0",
                    "<collision name=\"c\"><geometry>" + box(0.2, 0.2, 0.2) + "</geometry></collision>") +
                "</model>"));
        runFor(*scene, 3);
        return !dBodyIsEnabled(body(*scene, "m::link"));
    };
    const std::string rest = "<odemt:auto_disable><idle_time>0.5</idle_time></odemt:auto_disable>";
    EXPECT_FALSE(asleep("", ""));
    EXPECT_TRUE(asleep(rest, ""));
    EXPECT_FALSE(asleep(rest, "<allow_auto_disable>false</allow_auto_disable>"));
}

TEST(Physics, DampingTakesAShareOfTheSpeedAtEveryStep) {
    const auto scene = load(worldWith(
        R"(<gravity>0 0 0</gravity><physics type="ode">
        <max_step_size>0.01</max_step_size><odemt:damping><linear>0.1</linear><angular>0.2</angular></odemt:damping>
      </physics>)",
        "<model name=\"m\">" + linkOf1kg("link", "0 0 0 0 0 0") + "</model>" + "<model name=\"own\">" +
            linkOf1kg("link", "0 0 0 0 0 0",
                      "<velocity_decay><linear>0.5</linear><angular>0</angular></velocity_decay>") +
            "</model>"));
    for (const char *name : {"m::link", "own::link"}) {
        dBodySetLinearVel(body(*scene, name), 1, 0, 0);
        dBodySetAngularVel(body(*scene, name), 1, 0, 0);
    }
    run(*scene, 3);
    EXPECT_NEAR(velocity(body(*scene, "m::link")).x, std::pow(0.9, 3), 1e-12);
    EXPECT_NEAR(spin(body(*scene, "m::link")).x, std::pow(0.8, 3), 1e-12);
    EXPECT_NEAR(velocity(body(*scene, "own::link")).x, std::pow(0.5, 3), 1e-12);
    EXPECT_NEAR(spin(body(*scene, "own::link")).x, 1, 1e-12);
}

TEST(Physics, EverySpaceFindsTheSameContacts) {
    const struct {
        const char *type, *inside;
        int odeClass;
    } spaces[] = {
        {"simple", "", dSimpleSpaceClass},
        {"hash", "<min_level>-2</min_level><max_level>3</max_level>", dHashSpaceClass},
        {"sap", "", dSweepAndPruneSpaceClass},
        {"quadtree", "<center>0 0 0</center><extents>4 4 4</extents><depth>3</depth>", dQuadTreeSpaceClass}};
    for (const auto &space : spaces) {
        const auto scene =
            load(worldWith("<physics type=\"ode\"><odemt:space type=\"" + std::string(space.type) + "\">" +
                               space.inside + "</odemt:space></physics>",
                           ground + model("a", "0 0 0.0999 0 0 0", sphere(0.1)) +
                               model("b", "0.15 0 0.0999 0 0 0", sphere(0.1))));
        scene->frame();
        EXPECT_EQ(scene->contactCount(), 3u) << space.type;
        EXPECT_EQ(dGeomGetClass(reinterpret_cast<dGeomID>(scene->inventory().spaces.at(0))), space.odeClass);
    }
}

TEST(Physics, FrictionModelChoosesPyramidOrBox) {
    class Modes : public scenes::Observer {
    public:
        void contact(const dContact &contact) override { mode = contact.surface.mode; }
        int mode = -1;
    };
    for (const auto &[model, mode] :
         {std::pair("pyramid_model", +dContactApprox1), std::pair("box_model", 0)}) {
        const auto scene =
            load(worldWith("<physics type=\"ode\"><ode><solver><friction_model>" + std::string(model) +
                               "</friction_model></solver></ode></physics>",
                           ground + small_world::model("m", "0 0 0.09 0 0 0", sphere(0.1))));
        Modes watch;
        scene->observe(&watch);
        scene->frame();
        EXPECT_EQ(watch.mode, mode);
    }
}

TEST(Physics, CustomElementsAreChecked) {
    const auto physicsWith = [](const std::string &element) {
        return worldWith("<physics type=\"ode\">" + element + "</physics>", "");
    };
    using Kind = worlds::LoadError::Kind;
    expectError(physicsWith("<odemt:space type=\"octree\"/>"), Kind::Unsupported,
                {"test.sdf: /sdf/world/physics/odemt:space", "octree", "quadtree"});
    expectError(physicsWith("<odemt:space type=\"simple\"><min_level>1</min_level></odemt:space>"), Kind::Value,
                {"/sdf/world/physics/odemt:space/min_level", "hash"});
    expectError(physicsWith("<odemt:space type=\"hash\"><depth>3</depth></odemt:space>"), Kind::Value,
                {"/sdf/world/physics/odemt:space/depth", "quadtree"});
    expectError(physicsWith("<odemt:space type=\"simple\"><colour>red</colour></odemt:space>"),
                Kind::Unsupported, {"/sdf/world/physics/odemt:space/colour", "not supported"});
    expectError(physicsWith("<odemt:auto_disable><idle_time>-1</idle_time></odemt:auto_disable>"),
                Kind::Value, {"/sdf/world/physics/odemt:auto_disable/idle_time", "negative"});
    expectError(physicsWith("<odemt:damping><linear>fast</linear></odemt:damping>"), Kind::Value,
                {"/sdf/world/physics/odemt:damping/linear", "'fast'"});
    expectError(physicsWith("<odemt:contact_candidates>0</odemt:contact_candidates>"), Kind::Value,
                {"/sdf/world/physics/odemt:contact_candidates", "between 1 and 65535"});
    expectError(physicsWith("<odemt:gravity_well/>"), Kind::Unsupported,
                {"/sdf/world/physics/odemt:gravity_well"});
    expectError(physicsWith("<ode><solver><type>fast</type></solver></ode>"), Kind::Value,
                {"/sdf/world/physics/ode/solver/type", "'fast'"});
}

}  // namespace
