// Impossible values and files: the error says what is wrong, and where.
#include "small_world.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

const std::string collision = "test.sdf: /sdf/world/model[m]/link[link]/collision[shape]/";

std::string withGeometry(const std::string &geometry) { return world(model("m", "0 0 0 0 0 0", geometry)); }
std::string withInertial(const std::string &inertial) {
    return world("<model name=\"m\"><link name=\"link\"><inertial>" + inertial +
                 "</inertial></link></model>");
}
std::string withPhysics(const std::string &inside) {
    return worldWith("<physics type=\"ode\">" + inside + "</physics>", "");
}

TEST(Error, SizesHaveToBePositiveAndFinite) {
    expectError(withGeometry("<box><size>1 -1 1</size></box>"), Kind::Value,
                {collision + "geometry/box/size", "'1 -1 1' is negative"});
    expectError(withGeometry("<box><size>1 0 1</size></box>"), Kind::Value,
                {"geometry/box/size", "not positive"});
    expectError(withGeometry("<sphere><radius>-2</radius></sphere>"), Kind::Value,
                {collision + "geometry/sphere/radius", "negative"});
    expectError(withGeometry("<sphere><radius>nan</radius></sphere>"), Kind::Value,
                {collision + "geometry/sphere/radius", "not a number"});
    expectError(withGeometry("<sphere><radius>inf</radius></sphere>"), Kind::Value, {"not finite"});
    expectError(withGeometry("<cylinder><radius>1</radius><length>0</length></cylinder>"), Kind::Value,
                {collision + "geometry/cylinder/length", "not positive"});
    expectError(withGeometry("<capsule><radius>-1</radius><length>1</length></capsule>"), Kind::Value,
                {collision + "geometry/capsule/radius"});
    expectError(withGeometry("<mesh><uri>a.stl</uri><scale>1 1 -1</scale></mesh>"), Kind::Value,
                {collision + "geometry/mesh/scale"});
    expectError(withGeometry("<heightmap><uri>a.png</uri><size>1 0 1</size></heightmap>"), Kind::Value,
                {collision + "geometry/heightmap/size"});
}

TEST(Error, MassesHaveToBePositiveAndFinite) {
    const std::string path = "test.sdf: /sdf/world/model[m]/link[link]/inertial/";
    expectError(withInertial("<mass>0</mass>"), Kind::Value, {path + "mass", "not positive"});
    expectError(withInertial("<mass>-1</mass>"), Kind::Value, {path + "mass", "negative"});
    expectError(withInertial("<mass>nan</mass>"), Kind::Value, {path + "mass", "not a number"});
    expectError(withInertial("<mass>1</mass><inertia><ixx>nan</ixx><iyy>1</iyy><izz>1</izz></inertia>"),
                Kind::Value, {path + "inertia/ixx"});
}

TEST(Error, MassesOfStaticLinksMayBeZero) {
    const auto withMass = [](const std::string &isStatic, const std::string &mass) {
        return world("<model name=\"m\"><static>" + isStatic + "</static><link name=\"link\"><inertial><mass>" + mass +
                     "</mass><inertia><ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial></link></model>");
    };
    EXPECT_NO_THROW(load(withMass("true", "0")));
    expectError(withMass("false", "0"), Kind::Value, {"inertial/mass: '0' is not positive"});
    expectError(withMass("true", "-1"), Kind::Value, {"inertial/mass: '-1' is negative"});
}

TEST(Error, PosesHaveToBeFinite) {
    EXPECT_THROW(load(world("<model name=\"m\"><pose>0 0 nan 0 0 0</pose><link name=\"link\"/></model>")),
                 worlds::LoadError);
    EXPECT_THROW(load(world("<model name=\"m\"><pose>0 0 inf 0 0 0</pose><link name=\"link\"/></model>")),
                 worlds::LoadError);
}

TEST(Error, PhysicsHasToMakeSense) {
    expectError(withPhysics("<max_step_size>0</max_step_size>"), Kind::Value,
                {"test.sdf: /sdf/world/physics/max_step_size", "not positive"});
    expectError(withPhysics("<max_step_size>-0.1</max_step_size>"), Kind::Value, {"negative"});
    expectError(withPhysics("<ode><constraints><cfm>-1</cfm></constraints></ode>"), Kind::Value,
                {"/sdf/world/physics/ode/constraints/cfm", "negative"});
    expectError(withPhysics("<ode><solver><iters>0</iters></solver></ode>"), Kind::Value,
                {"/sdf/world/physics/ode/solver/iters"});
    expectError(withPhysics("<max_contacts>-3</max_contacts>"), Kind::Value,
                {"/sdf/world/physics/max_contacts"});
}

TEST(Error, SurfacesHaveToMakeSense) {
    const auto surface = [](const std::string &inside) {
        return world(model("m", "0 0 0 0 0 0", sphere(1), "<surface>" + inside + "</surface>"));
    };
    expectError(surface("<contact><ode><soft_erp>-1</soft_erp></ode></contact>"), Kind::Value,
                {collision + "surface/contact/ode/soft_erp", "negative"});
    expectError(surface("<friction><ode><slip1>-1</slip1></ode></friction>"), Kind::Value,
                {collision + "surface/friction/ode/slip1"});
    expectError(
        worldWith("<physics type=\"ode\"><odemt:default_surface><friction><ode><slip1>-1</slip1></ode></friction>"
                  "</odemt:default_surface></physics>",
                  ""),
        Kind::Value, {"/sdf/world/physics/odemt:default_surface/friction/ode/slip1", "negative"});
    expectError(
        worldWith("<physics type=\"ode\"><odemt:default_surface><friction><ode><mu>slippery</mu></ode>"
                  "</friction></odemt:default_surface></physics>",
                  ""),
        Kind::Value, {"odemt:default_surface/friction/ode/mu", "'slippery' is not a number"});
}

TEST(Error, WordsAreNoNumbers) {
    expectError(withInertial("<mass>heavy</mass>"), Kind::Value,
                {"test.sdf: /sdf/world/model[m]/link[link]/inertial/mass: 'heavy' is not a number"});
    expectError(withGeometry("<box><size>1 2</size></box>"), Kind::Value,
                {"geometry/box/size: '1 2' has 2 numbers instead of 3"});
}

TEST(Error, BrokenXmlIsNamedWithItsLine) {
    expectError("<sdf version=\"1.9\"><world name=\"w\">\n<model", Kind::Syntax,
                {"test.sdf: not well-formed XML"});
    expectError("<sdf version=\"1.9\">\n<world name=\"w\"></sdf>", Kind::Syntax,
                {"not well-formed XML, line 2: mismatched tag"});
    expectError("", Kind::Syntax, {"test.sdf"});
    expectError("no XML at all", Kind::Syntax, {"test.sdf"});
    expectError("<robot name=\"urdf\"/>", Kind::Syntax, {"test.sdf: not SDF", "<sdf>"});
    expectError("<sdf version=\"1.9\"><light name=\"l\" type=\"point\"/></sdf>", Kind::Syntax,
                {"test.sdf: /sdf: holds neither a <world> nor one <model>"});
    expectError("<sdf><world name=\"w\"/></sdf>", Kind::Syntax, {"test.sdf", "version"});
    expectError("<sdf version=\"1.9\"><world name=\"a\"/><world name=\"b\"/></sdf>", Kind::Value,
                {"test.sdf: /sdf/world: is written twice"});
}

TEST(Error, StructureIsChecked) {
    expectError(world("<model name=\"m\"/>"), Kind::Value,
                {"test.sdf: /sdf/world/model[m]: needs an element link or model or include"});
    expectError(world("<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("a", "0 0 0 0 0 0") +
                      "</model>"),
                Kind::Value, {"test.sdf: /sdf/world/model[m]/link[a]: a second <link> is called 'a'"});
    expectError(
        world("<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") +
              "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>nobody</child></joint></model>"),
        Kind::Value, {"test.sdf: /sdf/world/model[m]/joint[j]/child: no frame 'nobody' in the model 'm'"});
    expectError(
        world("<model name=\"m\"><pose relative_to=\"nowhere\">0 0 0 0 0 0</pose><link name=\"l\"/></model>"),
        Kind::Value, {"test.sdf: /sdf/world/model[m]/pose: relative_to: no frame 'nowhere' in the world"});
    expectError(world("<include><uri>model://nobody</uri></include>"), Kind::Resource,
                {"test.sdf: /sdf/world/include/uri: no model 'model://nobody'"});
}

TEST(Error, FilesThatCannotBeReadAreNamed) {
    const auto message = [](const std::string &file) -> std::string {
        try {
            worlds::loadWorld(file);
        } catch (const worlds::LoadError &error) {
            EXPECT_EQ(error.kind(), Kind::File);
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(message("/nowhere/world.sdf"), "/nowhere/world.sdf: No such file or directory");
    EXPECT_EQ(message("/tmp"), "/tmp: is a folder");
    const auto empty =
        std::filesystem::path(testing::TempDir()) / ("empty_" + std::to_string(::getpid()) + ".sdf");
    std::ofstream{empty};
    EXPECT_EQ(message(empty), empty.string() + ": is empty");
    std::filesystem::remove(empty);
}

}  // namespace
