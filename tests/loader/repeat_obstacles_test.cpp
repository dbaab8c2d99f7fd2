// Worlds with more static shapes than their files have.
#include "small_world.h"

#include "loader/load_world.h"
#include "scenes/state_hash.h"

#include <cmath>

namespace {

using namespace small_world;

worlds::LoadOptions with(std::size_t staticShapes) {
    worlds::LoadOptions options;
    options.staticShapes = staticShapes;
    return options;
}

std::unique_ptr<worlds::SdfScene> loadNamed(const std::string &name, std::size_t staticShapes = 0) {
    return worlds::loadWorld(worlds::findWorld(name), with(staticShapes));
}

std::vector<std::string> copies(const worlds::SdfScene &scene) {
    std::vector<std::string> names;
    for (const std::string &name : scene.geomNames())
        if (name.find("repeated::") == 0) names.push_back(name);
    return names;
}

void expectOutside(const worlds::SdfScene &scene, double halfSide) {
    for (const std::string &name : copies(scene)) {
        dReal box[6];
        dGeomGetAABB(geom(scene, name), box);
        const bool outside =
            box[0] > halfSide || box[1] < -halfSide || box[2] > halfSide || box[3] < -halfSide;
        EXPECT_TRUE(outside) << name;
    }
}

TEST(RepeatObstacles, GivesTheNumberAskedFor) {
    for (const std::size_t count : {45u, 46u, 84u, 85u, 86u, 440u})
        EXPECT_EQ(staticGeoms(*loadNamed("pioneer3at", count)), count);
    for (const std::size_t count : {44u, 620u}) EXPECT_EQ(staticGeoms(*loadNamed("create", count)), count);
    EXPECT_EQ(staticGeoms(*loadNamed("pioneer3at", 4400)), 4400u);
}

TEST(RepeatObstacles, PostsKeepTheirSizeAndDistances) {
    const auto scene = loadNamed("pioneer3at", 440);
    ASSERT_EQ(copies(*scene).size(), 440u - 45);
    for (const std::string &name : copies(*scene)) {
        dReal radius = 0, length = 0;
        dGeomCylinderGetParams(geom(*scene, name), &radius, &length);
        EXPECT_EQ(radius, 0.4);
        EXPECT_EQ(length, 2);
    }
    const dReal *original = dGeomGetPosition(geom(*scene, "obstacles::posts::obstacle_1"));
    const dReal *copy = dGeomGetPosition(geom(*scene, "repeated::copy_1::obstacles::posts::obstacle_1"));
    EXPECT_NEAR(copy[0] - original[0], -60.4, 1e-9);  // the first copy is south-west of the arena
    EXPECT_NEAR(copy[1] - original[1], -60.4, 1e-9);
    EXPECT_EQ(copy[2], original[2]);
}

TEST(RepeatObstacles, CopiesStandOutsideOfTheWalls) {
    expectOutside(*loadNamed("pioneer3at", 440), 30);
    expectOutside(*loadNamed("create", 620), 4.85);
}

TEST(RepeatObstacles, CopyFurnitureButNoOuterWalls) {
    const auto scene = loadNamed("create", 44 + 39);
    EXPECT_EQ(copies(*scene).size(), 39u);
    int walls = 0;
    for (const std::string &name : copies(*scene)) walls += name.find("wall_1_east") != std::string::npos;
    EXPECT_EQ(walls, 0);
    const dReal *back = dGeomGetRotation(geom(*scene, "repeated::copy_1::armchair::armchair::back_cushion"));
    EXPECT_NEAR(back[10], std::cos(0.29), 1e-9);
}

TEST(RepeatObstacles, MoveNothingWithinTheWalls) {
    for (const auto &[name, count] : {std::pair("pioneer3at", 200), std::pair("create", 200)}) {
        const auto plain = loadNamed(name), scaled = loadNamed(name, count);
        for (int i = 0; i < 500; ++i) {
            plain->frame();
            scaled->frame();
        }
        EXPECT_EQ(scenes::stateHash(plain->inventory()), scenes::stateHash(scaled->inventory())) << name;
    }
}

TEST(RepeatObstacles, ShapesAtTheBorderThatAreNoWallsAreRepeated) {
    // The area is 4 m × 2 m: the long box is an outer wall, the posts are not.
    const std::string inside = staticModel("wall", "0 -0.9 0 0 0 0", box(4, 0.2, 1)) +
                               staticModel("west", "-1.9 0.9 0 0 0 0", box(0.2, 0.2, 1)) +
                               staticModel("east", "1.9 0 0 0 0 0", sphere(0.1));
    const auto scene = load(world(ground + inside), with(4 + 2));
    EXPECT_EQ(copies(*scene), (std::vector<std::string>{"repeated::copy_1::west::link::shape",
                                                        "repeated::copy_1::east::link::shape"}));
}

void expectError(const std::string &world, std::size_t count, const std::string &part) {
    try {
        loadNamed(world, count);
        ADD_FAILURE() << world;
    } catch (const worlds::LoadError &error) {
        EXPECT_NE(std::string(error.what()).find(world + ".sdf: /sdf/world: " + part), std::string::npos) << error.what();
    }
}

TEST(RepeatObstacles, NumbersThatCannotBeAreErrors) {
    expectError("pioneer3at", 44, "has 45 static shapes and cannot have 44");
    expectError("bioloid", 2, "has no static obstacles that could be repeated");
}

}  // namespace
