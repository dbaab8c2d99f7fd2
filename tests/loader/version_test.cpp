// What versions of SDF have in ways of their own.
#include "small_world.h"

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

std::string of(const std::string &version, const std::string &inside) {
    return "<sdf version=\"" + version + "\"><world name=\"w\">" + inside + "</world></sdf>";
}
std::string hinged(const std::string &axis) {
    return "<model name=\"m\"><link name=\"a\"/><link name=\"b\"><pose>0 0 0 0 0 "
           "1.5707963267948966</pose></link>"
           "<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>1 0 0</xyz>" +
           axis + "</axis></joint></model>";
}
Vector3 axisOf(const std::string &sdf) {
    const auto scene = load(sdf);
    dVector3 axis;
    dJointGetHingeAxis(joint(*scene, "m::j"), axis);
    return {axis[0], axis[1], axis[2]};
}
Vector3 gravityOf(const std::string &sdf) {
    const auto scene = load(sdf);
    dVector3 gravity;
    dWorldGetGravity(scene->inventory().worlds[0], gravity);
    return {gravity[0], gravity[1], gravity[2]};
}

TEST(Version, AllFrom1_2To1_12AreRead) {
    for (int version = 2; version <= 12; ++version)
        EXPECT_NO_THROW(load(of("1." + std::to_string(version), model("m", "0 0 0 0 0 0", sphere(1)))))
            << version;
    for (const char *const other : {"1.0", "1.13", "2.0", "1.9.1", "1.09", "9"})
        expectError(of(other, ""), Kind::Unsupported,
                    {"test.sdf: /sdf: version '" + std::string(other) + "': not supported; 1.2 to 1.12 are"});
}

TEST(Version, AxesAreTheModelsTo1_4AndTheJointsFrom1_5) {
    EXPECT_NEAR(axisOf(of("1.4", hinged(""))).x, 1, 1e-12);
    for (const char *const version : {"1.5", "1.6", "1.7", "1.11"})
        EXPECT_NEAR(axisOf(of(version, hinged(""))).y, 1, 1e-12) << version;
    for (const char *const version : {"1.5", "1.6"}) {
        EXPECT_NEAR(axisOf(of(version, hinged("<use_parent_model_frame>1</use_parent_model_frame>"))).x, 1,
                    1e-12)
            << version;
        EXPECT_NEAR(axisOf(of(version, hinged("<use_parent_model_frame>false</use_parent_model_frame>"))).y,
                    1, 1e-12)
            << version;
    }
    expectError(of("1.7", hinged("<use_parent_model_frame>1</use_parent_model_frame>")), Kind::Unsupported,
                {"/sdf/world/model[m]/joint[j]/axis/use_parent_model_frame: not supported"});
}

TEST(Version, GravityIsOfThePhysicsTo1_5) {
    const std::string gravity = "<gravity>1 2 3</gravity>",
                      inside = "<physics type=\"ode\">" + gravity + "</physics>";
    EXPECT_EQ(gravityOf(of("1.5", inside)), (Vector3{1, 2, 3}));
    EXPECT_EQ(gravityOf(of("1.6", gravity)), (Vector3{1, 2, 3}));
    expectError(of("1.6", inside), Kind::Unsupported, {"/sdf/world/physics/gravity: not supported"});
}

TEST(Version, StepsAreOfTheSolverTo1_3) {
    const std::string physics =
        "<physics "
        "type=\"ode\"><update_rate>100</update_rate><ode><solver><dt>0.005</dt></solver></ode></physics>";
    EXPECT_EQ(load(of("1.3", physics))->stepSize(), 0.005);
    expectError(of("1.4", physics), Kind::Unsupported, {"/sdf/world/physics/update_rate: not supported"});
}

TEST(Version, PosesNameFramesInOtherAttributesTo1_6) {
    const auto posed = [](const std::string &attribute) {
        return "<model name=\"m\"><link name=\"a\"><pose>1 0 0 0 0 0</pose></link><link name=\"b\"><pose " +
               attribute + "=\"a\">0 1 0 0 0 0</pose></link></model>";
    };
    for (const auto &[version, attribute] : {std::pair("1.6", "frame"), std::pair("1.7", "relative_to")})
        EXPECT_EQ(position(body(*load(of(version, posed(attribute))), "m::b")), (Vector3{1, 1, 0}))
            << version;
    expectError(of("1.7", posed("frame")), Kind::Unsupported,
                {"/model[m]/link[b]/pose: attribute 'frame': not supported"});
}

TEST(Version, NamesOfLinksAndJointsMayBeTheSameTo1_6) {
    const std::string same =
        "<model name=\"m\"><link name=\"a\"/><link name=\"b\"/><joint name=\"b\" "
        "type=\"fixed\"><parent>a</parent>"
        "<child>b</child></joint></model>";
    EXPECT_EQ(load(of("1.6", same))->jointNames(), std::vector<std::string>{"m::b"});
    expectError(of("1.7", same), Kind::Value, {"/model[m]/joint[b]: a <link> is called 'b', too"});
}

// Gazebo wrote models within models as one, with names of two parts.
TEST(Version, NamesMayHaveTwoPartsTo1_7) {
    const std::string flat =
        "<model name=\"m\"><link name=\"arm::a\"><pose relative_to=\"arm::__model__\">0 1 0 0 0 "
        "0</pose></link>"
        "<link name=\"b\"/><frame name=\"arm::__model__\" attached_to=\"arm::a\"><pose "
        "relative_to=\"__model__\">"
        "1 0 0 0 0 0</pose></frame><joint name=\"arm::j\" "
        "type=\"fixed\"><parent>b</parent><child>arm::a</child>"
        "</joint></model>";
    const auto scene = load(of("1.7", flat));
    EXPECT_EQ(position(body(*scene, "m::arm::a")), (Vector3{1, 1, 0}));
    EXPECT_EQ(dJointGetBody(joint(*scene, "m::arm::j"), 0), body(*scene, "m::arm::a"));
    expectError(of("1.8", flat), Kind::Value, {"/model[m]/link[arm::a]: a name may not hold '::'"});
}

}  // namespace
