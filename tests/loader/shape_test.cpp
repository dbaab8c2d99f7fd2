// Every shape is there with its size, lies where it should, and rests on the floor.
#include "small_world.h"

#include <cmath>

namespace {

using namespace small_world;

const std::string cylinder = "<cylinder><radius>0.1</radius><length>0.4</length></cylinder>";
const std::string capsule = "<capsule><radius>0.1</radius><length>0.4</length></capsule>";

struct RestingShape {
    const char *name;
    std::string geometry;
    std::string rotation;
    double height;  // of the centre above the floor
};
void PrintTo(const RestingShape &shape, std::ostream *out) { *out << shape.name; }

class Resting : public testing::TestWithParam<RestingShape> {};

TEST_P(Resting, OnTheFloor) {
    const RestingShape &shape = GetParam();
    const auto scene = load(world(ground + model("m", "0 0 0.35 " + shape.rotation, shape.geometry)));
    runFor(*scene, 1);
    EXPECT_NEAR(position(body(*scene, "m::link")).z, shape.height, 1e-3);
    EXPECT_GT(scene->contactCount(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Resting,
    testing::Values(RestingShape{"box", box(0.2, 0.4, 0.6), "0 0 0", 0.3},
                    RestingShape{"sphere", sphere(0.25), "0 0 0", 0.25},
                    RestingShape{"cylinder", cylinder, "0 0 0", 0.2},
                    RestingShape{"lyingCylinder", cylinder, "1.5707963267948966 0 0", 0.1},
                    RestingShape{"capsule", capsule, "0 0 0", 0.3},
                    RestingShape{"lyingCapsule", capsule, "0 1.5707963267948966 0", 0.1}),
    [](const auto &info) { return info.param.name; });

TEST(Shape, PlaneStandsWhereItsPoseAndNormalSay) {
    // A quarter turn about y takes the normal x to -z; 2 m up, it is a ceiling.
    const auto scene = load(
        world(staticModel("p", "0 0 2 0 1.5707963267948966 0", "<plane><normal>1 0 0</normal></plane>")));
    dVector4 plane;
    dGeomPlaneGetParams(geom(*scene, "p::link::shape"), plane);
    EXPECT_NEAR(plane[2], -1, 1e-9);
    EXPECT_NEAR(plane[3], -2, 1e-9);
}

TEST(Shape, CollisionPoseCountsFromTheLinkNotFromTheCentreOfMass) {
    const auto scene = load(world(R"(
      <model name="m"><pose>1 2 3 0 0 1.5707963267948966</pose><link name="link">
        <inertial><pose>0.5 0 0 0 0 0</pose><mass>1</mass>
          <inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>
        <collision name="shape"><pose>0.1 0 0 0 0 0.3</pose><geometry>)" +
                                  sphere(0.1) + R"(</geometry></collision>
      </link></model>)"));
    const dReal *at = dGeomGetPosition(geom(*scene, "m::link::shape"));
    EXPECT_NEAR(at[0], 1, 1e-9);  // turned by a quarter, x is y
    EXPECT_NEAR(at[1], 2.1, 1e-9);
    EXPECT_NEAR(at[2], 3, 1e-9);
    EXPECT_NEAR(position(body(*scene, "m::link")).y, 2.5, 1e-9);
    EXPECT_NEAR(dGeomGetRotation(geom(*scene, "m::link::shape"))[0], std::cos(1.5707963267948966 + 0.3),
                1e-9);
}

TEST(Shape, EmptyGeometryIsNoShape) {
    const auto scene = load(world(model("m", "0 0 1 0 0 0", "<empty/>")));
    EXPECT_TRUE(scene->inventory().geoms.empty());
    EXPECT_EQ(scene->inventory().bodies.size(), 1u);
}

}  // namespace
