// Files that a world names: meshes and height maps.
#include "small_world.h"

#include <stb_image_write.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using namespace small_world;
namespace fs = std::filesystem;

// A folder of its own for the files of a test.
class Resource : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("resource_test_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string &name, const std::string &text) const {
        std::ofstream(folder / name) << text;
    }

    std::unique_ptr<worlds::SdfScene> loadBeside(const std::string &inside) const {
        return worlds::loadWorldText(world(inside), folder / "test.sdf");
    }

    void expectResourceError(const std::string &geometry, const std::vector<std::string> &parts) const {
        try {
            loadBeside(staticModel("m", "0 0 0 0 0 0", geometry));
            ADD_FAILURE() << "loaded " << geometry;
        } catch (const worlds::LoadError &error) {
            EXPECT_EQ(error.kind(), worlds::LoadError::Kind::Resource) << error.what();
            for (const std::string &part : parts)
                EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    fs::path folder;
};

std::string mesh(const std::string &uri, const std::string &scale = "") {
    return "<mesh><uri>" + uri + "</uri>" + (scale.empty() ? "" : "<scale>" + scale + "</scale>") + "</mesh>";
}

// Corners of the cube of side 1 around the origin, and its faces as squares.
const double corners[8][3] = {{-.5, -.5, -.5}, {.5, -.5, -.5}, {.5, .5, -.5}, {-.5, .5, -.5},
                              {-.5, -.5, .5},  {.5, -.5, .5},  {.5, .5, .5},  {-.5, .5, .5}};
const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string cornerText(int corner) {
    const double *c = corners[corner];
    return std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]);
}

std::string cubeObj() {
    std::string text;
    for (int i = 0; i < 8; ++i) text += "v " + cornerText(i) + "\n";
    for (const auto &face : faces) {
        text += "f";
        for (const int corner : face) text += " " + std::to_string(corner + 1);
        text += "\n";
    }
    return text;
}

std::string cubeStl() {
    std::string text = "solid cube\n";
    const int halves[][3] = {{0, 1, 2}, {0, 2, 3}};
    for (const auto &face : faces)
        for (const auto &triangle : halves) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (int i = 0; i < 3; ++i) text += "vertex " + cornerText(face[triangle[i]]) + "\n";
            text += "endloop\nendfacet\n";
        }
    return text + "endsolid cube\n";
}

std::string cubeDae(const std::string &upAxis) {
    std::string positions, indices;
    for (int i = 0; i < 8; ++i) positions += cornerText(i) + " ";
    for (const auto &face : faces)
        for (const int corner : {face[0], face[1], face[2], face[0], face[2], face[3]})
            indices += std::to_string(corner) + " ";
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
      <asset><up_axis>)" +
           upAxis + R"(</up_axis></asset>
      <library_geometries><geometry id="g"><mesh>
        <source id="p"><float_array id="a" count="24">)" +
           positions + R"(</float_array>
          <technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/>
          <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
           indices + R"(</p></triangles>
      </mesh></geometry></library_geometries>
      <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
      </library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

// The box around a geom: smallest and largest x, y and z.
std::vector<double> boundsOf(dGeomID geom) {
    dReal box[6];
    dGeomGetAABB(geom, box);
    return {box, box + 6};
}

TEST_F(Resource, MeshesOfThreeFormatsHaveTheirSize) {
    write("cube.obj", cubeObj());
    write("cube.stl", cubeStl());
    write("cube.dae", cubeDae("Z_UP"));
    write("cube_y.dae", cubeDae("Y_UP"));  // coordinates stay as they are
    for (const char *file : {"cube.obj", "cube.stl", "cube.dae", "cube_y.dae"}) {
        const auto scene = loadBeside(staticModel("m", "1 0 0 0 0 0", mesh(file, "2 4 6")));
        const dGeomID geom = small_world::geom(*scene, "m::link::shape");
        EXPECT_EQ(dGeomGetClass(geom), dTriMeshClass);
        EXPECT_EQ(dGeomTriMeshGetTriangleCount(geom), 12) << file;
        const std::vector<double> expected = {0, 2, -2, 2, -3, 3}, bounds = boundsOf(geom);
        for (int i = 0; i < 6; ++i) EXPECT_NEAR(bounds[i], expected[i], 1e-6) << file;
    }
}

TEST_F(Resource, BallRestsOnAMeshAndAMeshOnTheFloor) {
    write("cube.stl", cubeStl());
    const auto onMesh = loadBeside(staticModel("m", "0 0 0 0 0 0", mesh("cube.stl", "2 2 2")) +
                                   model("ball", "0.2 0.3 1.2 0 0 0", sphere(0.1)));
    runFor(*onMesh, 1);
    EXPECT_NEAR(position(body(*onMesh, "ball::link")).z, 1.1, 1e-3);

    const auto moving = loadBeside(ground + model("m", "0 0 0.6 0 0 0", mesh("cube.stl")));
    runFor(*moving, 1);
    EXPECT_NEAR(position(body(*moving, "m::link")).z, 0.5, 1e-3);
}

std::string heightmap(const std::string &uri, const std::string &extra = "") {
    return "<heightmap><uri>" + uri + "</uri><size>4 2 1</size>" + extra + "</heightmap>";
}

// The height of a ball of 0.1 m that was dropped on the map.
double restingHeight(worlds::SdfScene &scene) {
    runFor(scene, 1.5);
    return position(body(scene, "ball::link")).z - 0.1;
}

TEST_F(Resource, HeightMapHasItsTopEdgeAtTheLargestY) {
    // 3 x 3 samples: the top row is white, the others are black.
    const unsigned char pixels[9] = {255, 255, 255, 0, 0, 0, 0, 0, 0};
    ASSERT_TRUE(stbi_write_png((folder / "edge.png").c_str(), 3, 3, 1, pixels, 3));
    const auto low = loadBeside(staticModel("m", "0 0 0 0 0 0", heightmap("edge.png")) +
                                model("ball", "0.5 -0.5 1.2 0 0 0", sphere(0.1)));
    EXPECT_NEAR(restingHeight(*low), 0, 2e-3);
    const auto bounds = boundsOf(geom(*low, "m::link::shape"));
    EXPECT_NEAR(bounds[0], -2, 1e-6);
    EXPECT_NEAR(bounds[1], 2, 1e-6);
    EXPECT_NEAR(bounds[2], -1, 1e-6);
    EXPECT_NEAR(bounds[3], 1, 1e-6);
    EXPECT_NEAR(bounds[5], 1, 1e-6);

    // Halfway up the slope the height is a half; the ball is pinned to y = 0.5 by its start, so it is checked at once.
    const auto slope = loadBeside(staticModel("m", "0 0 0 0 0 0", heightmap("edge.png")) +
                                  model("ball", "0.5 0.5 0.55 0 0 0", sphere(0.1)));
    slope->frame();
    EXPECT_GT(slope->contactCount(), 0u);
}

TEST_F(Resource, HeightMapScalesMovesAndTurns) {
    // Half grey with 16 bits, as PNM.
    std::ofstream(folder / "half.pgm", std::ios::binary) << "P5\n2 2\n255\n" << std::string(4, '\x80');
    const auto scene =
        loadBeside(staticModel("m", "0 0 2 0 0 0.7", heightmap("half.pgm", "<pos>0 0 0.25</pos>")) +
                   model("ball", "0 0 3 0 0 0", sphere(0.1)));
    EXPECT_NEAR(restingHeight(*scene), 2 + 0.25 + 128.0 / 255, 2e-3);
}

TEST_F(Resource, MissingAndBrokenFilesAreNamed) {
    const std::string path = "test.sdf: /sdf/world/model[m]/link[link]/collision[shape]/geometry/";
    expectResourceError(mesh("nothing.stl"), {path + "mesh: ", "no file 'nothing.stl'"});
    expectResourceError(mesh("model://nobody/nothing.stl"), {"no file 'model://nobody/nothing.stl'"});
    expectResourceError(heightmap("nothing.png"), {path + "heightmap: ", "no file 'nothing.png'"});
    write("broken.stl", "solid\nfacet normal what");
    expectResourceError(mesh("broken.stl"), {path + "mesh: ", "broken.stl: "});
    write("broken.obj", "this is no mesh");
    expectResourceError(mesh("broken.obj"), {"broken.obj: "});
    write("text.xyz", "neither");
    expectResourceError(mesh("text.xyz"), {"text.xyz: "});
    write("broken.png", "this is no image");
    expectResourceError(heightmap("broken.png"), {path + "heightmap: ", "broken.png: "});
    write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    expectResourceError(mesh("points.obj"), {"points.obj: "});
    write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectResourceError(mesh("nan.obj"), {"nan.obj: "});
    const unsigned char pixel = 1;
    ASSERT_TRUE(stbi_write_png((folder / "tiny.png").c_str(), 1, 1, 1, &pixel, 1));
    expectResourceError(heightmap("tiny.png"), {"tiny.png: ", "2 x 2"});
}

TEST_F(Resource, MeshIsFoundByAbsoluteNameAndUri) {
    write("cube.stl", cubeStl());
    const std::string file = folder / "cube.stl";
    for (const std::string &uri : {file, "file://" + file})
        EXPECT_NO_THROW(load(world(staticModel("m", "0 0 0 0 0 0", mesh(uri))))) << uri;
}

}  // namespace
