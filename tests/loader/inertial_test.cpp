// Mass, centre of mass and inertia, in a frame of their own.
#include "small_world.h"

namespace {

using namespace small_world;

std::string modelWith(const std::string &inertial, const std::string &pose = "0 0 0 0 0 0") {
    return world("<model name=\"m\"><pose>" + pose + "</pose><link name=\"link\">" + inertial +
                 "</link></model>");
}

dMass massOf(const worlds::SdfScene &scene) { return small_world::massOf(body(scene, "m::link")); }

TEST(Inertial, TakesOffDiagonals) {
    const auto scene = load(modelWith(R"(<inertial><mass>2</mass><inertia>
        <ixx>0.4</ixx><iyy>0.5</iyy><izz>0.6</izz><ixy>0.01</ixy><ixz>0.02</ixz><iyz>-0.03</iyz>
      </inertia></inertial>)"));
    const dMass mass = massOf(*scene);
    EXPECT_DOUBLE_EQ(mass.mass, 2);
    EXPECT_NEAR(mass.I[0], 0.4, 1e-12);
    EXPECT_NEAR(mass.I[5], 0.5, 1e-12);
    EXPECT_NEAR(mass.I[10], 0.6, 1e-12);
    EXPECT_NEAR(mass.I[1], 0.01, 1e-12);
    EXPECT_NEAR(mass.I[2], 0.02, 1e-12);
    EXPECT_NEAR(mass.I[6], -0.03, 1e-12);
}

TEST(Inertial, TurnsItsFrameIntoTheLinks) {
    // A quarter turn about z swaps the moments about x and y, and changes the sign of the product.
    const auto scene =
        load(modelWith(R"(<inertial><pose>0.1 0.2 0.3 0 0 1.5707963267948966</pose><mass>1</mass>
        <inertia><ixx>0.4</ixx><iyy>0.5</iyy><izz>0.6</izz><ixy>0.05</ixy></inertia></inertial>)",
                       "1 0 0 0 0 0"));
    const dMass mass = massOf(*scene);
    EXPECT_NEAR(mass.I[0], 0.5, 1e-12);
    EXPECT_NEAR(mass.I[5], 0.4, 1e-12);
    EXPECT_NEAR(mass.I[1], -0.05, 1e-12);
    EXPECT_LT((position(body(*scene, "m::link")) - Vector3{1.1, 0.2, 0.3}).length(), 1e-12);
    EXPECT_DOUBLE_EQ(dBodyGetQuaternion(body(*scene, "m::link"))[0], 1);  // axes are the link's
}

TEST(Inertial, DefaultsAreSdfs) {
    const auto scene = load(modelWith(""));
    EXPECT_DOUBLE_EQ(massOf(*scene).mass, 1);
    EXPECT_DOUBLE_EQ(massOf(*scene).I[0], 1);
}

// A body turned by a torque about its axis of least inertia speeds up as the matrix says.
TEST(Inertial, DecidesHowABodySpins) {
    const auto scene = load(modelWith(R"(<inertial><mass>1</mass>
        <inertia><ixx>0.2</ixx><iyy>0.3</iyy><izz>0.4</izz></inertia></inertial>)"));
    dBodyAddTorque(body(*scene, "m::link"), 0, 0, 4);
    scene->frame();
    EXPECT_NEAR(spin(body(*scene, "m::link")).z, 4 / 0.4 * 0.001, 1e-9);
}

TEST(Inertial, MatrixHasToBePossible) {
    const auto inertia = [](const std::string &terms) {
        return modelWith("<inertial><mass>1</mass><inertia>" + terms + "</inertia></inertial>");
    };
    using Kind = worlds::LoadError::Kind;
    expectError(inertia("<ixx>0</ixx><iyy>1</iyy><izz>1</izz>"), Kind::Value,
                {"test.sdf: /sdf/world/model[m]/link[link]/inertial/inertia/ixx", "not positive"});
    EXPECT_THROW(load(inertia("<ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>5</ixy>")), worlds::LoadError);
}

// One moment larger than the other two together belongs to no body. Gazebo says so, and takes it.
TEST(Inertial, ThatNoBodyHasIsTakenWithAWarning) {
    const Loaded loaded = loadWithWarnings(
        modelWith("<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>5</izz></inertia></inertial>"));
    EXPECT_EQ(loaded.warnings,
              std::vector<std::string>{"test.sdf: /sdf/world/model[m]/link[link]/inertial/inertia: no body has such an inertia "
                                       "matrix: a moment is above the sum of the others"});
    EXPECT_EQ(massOf(*loaded.scene).I[10], 5);
}

}  // namespace
