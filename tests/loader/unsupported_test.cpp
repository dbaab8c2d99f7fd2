// An unsupported element is named with file and path, and ignored only on demand.
#include "small_world.h"

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

const std::string axis = "<axis><xyz>0 0 1</xyz></axis>";

std::string jointed(const std::string &type, const std::string &inside) {
    return world("<model name=\"robot\">" + linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", "1 0 0 0 0 0") +
                 "<joint name=\"j1\" type=\"" + type + "\"><parent>a</parent><child>b</child>" + inside +
                 "</joint></model>");
}
std::string linked(const std::string &inside) {
    return world("<model name=\"m\">" + linkOf1kg("link", "0 0 0 0 0 0", inside) + "</model>");
}
std::string withSurface(const std::string &inside) {
    return world(model("m", "0 0 0 0 0 0", sphere(1), "<surface>" + inside + "</surface>"));
}

struct Case {
    const char *name;
    std::string sdf, path;
};
void PrintTo(const Case &element, std::ostream *out) { *out << element.name; }

class Unsupported : public testing::TestWithParam<Case> {};

TEST_P(Unsupported, IsNamedWithFileAndPath) {
    expectError(GetParam().sdf, Kind::Unsupported, {"test.sdf: " + GetParam().path, "not supported"});
}

TEST_P(Unsupported, IsLeftOutOnDemand) {
    worlds::LoadOptions options;
    options.ignoreUnsupported = true;
    std::vector<std::string> warnings;
    options.warnings = &warnings;
    const auto scene = load(GetParam().sdf, options);
    run(*scene, 10);
    EXPECT_TRUE(isFinite(*scene));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].find("test.sdf: " + GetParam().path), 0u) << warnings[0];

    options.warnings = nullptr;
    EXPECT_NO_THROW(load(GetParam().sdf, options));
}

const std::string robot = "/sdf/world/model[robot]/joint[j1]",
                  shape = "/sdf/world/model[m]/link[link]/collision[shape]";

INSTANTIATE_TEST_SUITE_P(
    Elements, Unsupported,
    testing::Values(
        Case{"gearboxRatio", jointed("revolute", axis + "<gearbox_ratio>2</gearbox_ratio>"),
             robot + "/gearbox_ratio"},
        Case{"motorOfABall", jointed("ball", "<physics><ode><max_force>1</max_force></ode></physics>"),
             robot + "/physics/ode/max_force"},
        Case{"stopsOfAFixed", jointed("fixed", "<physics><ode><limit><cfm>0.1</cfm></limit></ode></physics>"),
             robot + "/physics/ode/limit"},
        Case{"screw", jointed("screw", axis + "<thread_pitch>1</thread_pitch>"), robot + ": type 'screw'"},
        Case{"limitStiffness",
             jointed("revolute",
                     "<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>1</upper>"
                     "<stiffness>5</stiffness></limit></axis>"),
             robot + "/axis/limit/stiffness"},
        Case{"suspensionOfAHinge",
             jointed("revolute", axis + "<physics><ode><suspension><cfm>0</cfm><erp>0.2</erp>"
                                        "</suspension></ode></physics>"),
             robot + "/physics/ode/suspension"},
        Case{"ellipsoid", world(model("m", "0 0 0 0 0 0", "<ellipsoid><radii>1 2 3</radii></ellipsoid>")),
             shape + "/geometry/ellipsoid"},
        Case{"polyline",
             world(model("m", "0 0 0 0 0 0",
                         "<polyline><height>1</height><point>0 0</point><point>1 0"
                         "</point><point>0 1</point></polyline>")),
             shape + "/geometry/polyline"},
        Case{"twoPolylines",
             world(model("m", "0 0 0 0 0 0", "<polyline><height>1</height></polyline><polyline><height>2</height></polyline>")),
             shape + "/geometry/polyline"},
        Case{"planeThatMoves", world(model("m", "0 0 0 0 0 0", "<plane/>")), shape + "/geometry"},
        Case{"torsionalFriction",
             withSurface("<friction><torsional><patch_radius>0.1</patch_radius></torsional></friction>"),
             shape + "/surface/friction/torsional/patch_radius"},
        Case{"linkInTheWind", linked("<enable_wind>true</enable_wind>"),
             "/sdf/world/model[m]/link[link]/enable_wind"},
        Case{"unknownElement", linked("<colour>red</colour>"), "/sdf/world/model[m]/link[link]/colour"},
        Case{"foreignElement", linked("<ros:topic>a</ros:topic>"),
             "/sdf/world/model[m]/link[link]/ros:topic"},
        Case{"gripper",
             world("<model name=\"m\"><link name=\"link\"/><gripper name=\"g\"><gripper_link>link"
                   "</gripper_link><palm_link>link</palm_link></gripper></model>"),
             "/sdf/world/model[m]/gripper[g]"},
        Case{
            "plugin",
            world(
                "<model name=\"m\"><link name=\"link\"/><plugin name=\"p\" filename=\"libros.so\"/></model>"),
            "/sdf/world/model[m]/plugin[p]: filename 'libros.so'"},
        Case{"pluginOfGazebo",
             world("<model name=\"m\"><link name=\"link\"/><plugin name=\"gz::sim::systems::Lift\" filename=\"gz-sim-lift\"/>"
                   "</model>"),
             "/sdf/world/model[m]/plugin[gz::sim::systems::Lift]: filename 'gz-sim-lift'"},
        Case{"worldPlugin", world("<plugin name=\"p\" filename=\"libwind.so\"/>"),
             "/sdf/world/plugin[p]: filename 'libwind.so'"},
        Case{"attribute", world("<model name=\"m\" weight=\"2\"><link name=\"link\"/></model>"),
             "/sdf/world/model[m]"}),
    [](const auto &info) { return info.param.name; });

TEST(Supported, IsWhatChangesNoMotion) {
    EXPECT_NO_THROW(load(world(R"(
      <light name="sun" type="directional"/><scene><shadows>true</shadows></scene>
      <plugin name="gz::sim::systems::Physics" filename="gz-sim-physics-system"/>
      <model name="m"><enable_wind>false</enable_wind><link name="link">
        <visual name="v"><geometry><ellipsoid><radii>1 1 1</radii></ellipsoid></geometry></visual>
        <sensor name="s" type="imu"/>
        <collision name="c"><laser_retro>1</laser_retro><geometry><sphere><radius>1</radius></sphere></geometry>
          <surface><friction><bullet><friction>1</friction></bullet></friction></surface></collision>
      </link></model>)")));
}

TEST(Supported, IsWhatDoesNothing) {
    EXPECT_NO_THROW(load(withSurface(
        "<friction><torsional><coefficient>0.7</coefficient><use_patch_radius>1</use_patch_radius><patch_radius>0</patch_radius>"
        "<surface_radius>0.0</surface_radius><ode><slip>0</slip></ode></torsional></friction>"
        "<contact><ode><max_vel>0.01</max_vel><min_depth>0</min_depth></ode></contact>")));
    for (const char *const engine : {"ignored", "ignore", "none"})
        EXPECT_EQ(load(worldWith("<physics type=\"" + std::string(engine) + "\"><max_step_size>0.25</max_step_size></physics>", ""))->stepSize(),
                  0.25);
}

TEST(Supported, IsNeutralWhereItHoldsTheDefault) {
    EXPECT_NO_THROW(
        load(worldWith("<physics type=\"ode\"><ode><solver><use_dynamic_moi_rescaling>0"
                       "</use_dynamic_moi_rescaling><precon_iters>0</precon_iters></solver></ode></physics>",
                       "")));
    // How Gazebo integrates damping and springs is not how they act.
    for (const char *const way : {"cfm_damping", "implicit_spring_damper"})
        for (const char *const flag : {"true", "false"}) {
            const std::string element = std::string("<") + way + ">" + flag + "</" + way + ">";
            EXPECT_TRUE(
                loadWithWarnings(jointed("revolute", axis + "<physics><ode>" + element + "</ode></physics>")).warnings.empty());
        }
}

void expectOneWarning(const std::string &sdf, const std::string &expected) {
    const std::vector<std::string> warnings = loadWithWarnings(sdf).warnings;
    ASSERT_EQ(warnings.size(), 1u) << sdf;
    EXPECT_EQ(warnings[0], "test.sdf: " + expected);
}

TEST(LeftAside, WithAWarningIsWhatIsOfTheSolver) {
    const std::string left = ": left aside: ", ofContacts = shape + "/surface/contact/ode/";
    expectOneWarning(withSurface("<contact><ode><min_depth>0.01</min_depth></ode></contact>"),
                     ofContacts + "min_depth" + left + "ODE has one for all contacts, <contact_surface_layer>");
    expectOneWarning(withSurface("<contact><ode><max_vel>1</max_vel></ode></contact>"),
                     ofContacts + "max_vel" + left + "ODE has one for all contacts, <contact_max_correcting_vel>");
    for (const char *const of : {"use_dynamic_moi_rescaling", "precon_iters", "thread_position_correction"})
        expectOneWarning(worldWith("<physics type=\"ode\"><ode><solver><" + std::string(of) + ">1</" + of +
                                       "></solver></ode></physics>",
                                   ""),
                         "/sdf/world/physics/ode/solver/" + std::string(of) + left + "the solver of Gazebo's own ODE alone has it");
}

// Its steps and gravity are those of the file.
TEST(LeftAside, WithAWarningIsAnotherEngine) {
    for (const std::string engine : {"bullet", "dart", "simbody", "tpe"}) {
        const std::string sdf = worldWith("<physics type=\"" + engine + "\"><max_step_size>0.25</max_step_size></physics>", "");
        expectOneWarning(sdf, "/sdf/world/physics: type '" + engine + "': the engine is ODE nevertheless");
        EXPECT_EQ(load(sdf)->stepSize(), 0.25);
    }
}

// Worlds that Gazebo has saved hold it.
TEST(LeftAside, WithAWarningIsTheState) {
    const std::string state = "<state world_name=\"test\"><model name=\"m\"><pose>1 2 3 0 0 0</pose></model></state>";
    expectOneWarning(world(model("m", "0 0 0 0 0 0", sphere(1)) + state),
                     "/sdf/world/state: left aside: models start where <model> says, as in Gazebo Sim");
}

TEST(Unsupported, EveryOneIsInTheWarnings) {
    worlds::LoadOptions options;
    options.ignoreUnsupported = true;
    std::vector<std::string> warnings;
    options.warnings = &warnings;
    const auto scene =
        load(world("<model name=\"m\">" +
                   linkOf1kg("a", "0 0 0 0 0 0", "<enable_wind>true</enable_wind><colour>red</colour>") +
                   linkOf1kg("b", "1 0 0 0 0 0") +
                   "<joint name=\"j\" type=\"gearbox\"><parent>a</parent><child>b</child>" + axis +
                   "<axis2><xyz>0 0 "
                   "1</xyz></axis2><gearbox_reference_body>a</gearbox_reference_body></joint></model>"),
             options);
    EXPECT_EQ(warnings.size(), 3u);
    EXPECT_TRUE(scene->inventory().joints.empty());
    EXPECT_EQ(scene->inventory().bodies.size(), 2u);
}

}  // namespace
