// Files of meshes that lie about what they hold: none crashes the importer, none is taken for another mesh.
#include "small_world.h"
#include "test_folder.h"

#include <cstring>

namespace {

using namespace small_world;

class MeshCheck : public testing::Test {
protected:
    std::string message(const std::string &file, const std::string &text) const {
        folder.write(file, text);
        try {
            load(file);
        } catch (const worlds::LoadError &error) {
            EXPECT_EQ(error.kind(), worlds::LoadError::Kind::Resource);
            EXPECT_NE(std::string(error.what()).find("/geometry/mesh: mesh file " + folder.path(file) + ": "),
                      std::string::npos)
                << error.what();
            return error.what();
        }
        return "loaded";
    }
    void expectFault(const std::string &file, const std::string &text, const std::string &reason) const {
        const std::string what = message(file, text);
        EXPECT_NE(what.find(reason), std::string::npos) << what << "\n  does not say " << reason << "\n"
                                                        << text.substr(0, 2000);
    }
    std::unique_ptr<worlds::SdfScene> load(const std::string &file) const {
        return worlds::loadWorldText(
            world(staticModel("m", "0 0 0 0 0 0", "<mesh><uri>" + file + "</uri></mesh>")),
            folder.path("test.sdf"));
    }
    int triangles(const std::string &file, const std::string &text) const {
        folder.write(file, text);
        return dGeomTriMeshGetTriangleCount(geom(*load(file), "m::link::shape"));
    }

    TestFolder folder{"mesh_check"};
};

// `text` with its first `from` replaced.
std::string with(std::string text, const std::string &from, const std::string &to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::invalid_argument("no " + from);
    return text.replace(at, from.size(), to);
}

TEST_F(MeshCheck, OtherFormatsAreRefused) {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char *const corner : {"2", "-1", "9", "2000000000"})
        expectFault("m.ply", with(ply, "3 0 1 2", std::string("3 0 1 ") + corner),
                    "is none of .dae, .obj and .stl");
    expectFault("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "is none of .dae, .obj and .stl");
    expectFault("mesh", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "is none of");
    EXPECT_NE(message("m.stl", ply), "loaded");  // the name decides, not what is inside
    EXPECT_NE(message("m.obj", ply), "loaded");
    EXPECT_NE(message("m.dae", ply), "loaded");
}

const std::string tetrahedron = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>
    <accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
      <param name="Z" type="float"/></accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles>
</mesh></geometry></library_geometries>
<library_nodes></library_nodes>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST_F(MeshCheck, ColladaThatIsTrueLoads) {
    EXPECT_EQ(triangles("m.dae", tetrahedron), 4);
    // With normals between, in another unit, and twice, once through a library.
    EXPECT_EQ(
        triangles(
            "m.dae",
            with(with(tetrahedron, "<triangles count=\"4\"><input",
                      "<triangles count=\"1\"><input offset=\"1\" semantic=\"NORMAL\" source=\"#n\"/><input"),
                 "0 2 1 0 1 3 1 2 3 0 3 2", "0 9 <!-- to --> 2 9 1 9")),
        1);
    const std::string twice = with(with(tetrahedron, "<library_nodes>",
                                        "<library_nodes><node id=\"l\"><translate>5 0 "
                                        "0</translate><instance_geometry url=\"#g\"/></node>"),
                                   "<instance_geometry url=\"#g\"/></node></visual_scene>",
                                   "<scale>2 2 2</scale><instance_geometry url=\"#g\"/><instance_node "
                                   "url=\"#l\"/></node></visual_scene>");
    EXPECT_EQ(triangles("m.dae", with(twice, "meter=\"1\"", "meter=\"0.1\"")), 8);
    const auto scene = load("m.dae");
    dReal box[6];
    dGeomGetAABB(geom(*scene, "m::link::shape"), box);
    EXPECT_NEAR(box[0], 0, 1e-6);
    EXPECT_NEAR(box[1], (5 + 1) * 2 * 0.1, 1e-6);
    EXPECT_NEAR(box[3], 2 * 0.1, 1e-6);
}

// SketchUp writes such nodes. Nodes that show something have to be true nevertheless.
TEST_F(MeshCheck, ColladaWithCamerasAnywhere) {
    const std::string scene = "<visual_scene id=\"s\">", nowhere = "<matrix>NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN</matrix>";
    const auto camera = [&](const std::string &matrix) {
        return "<node>" + matrix + "<instance_camera url=\"#c\"/></node><node>" + matrix + "</node>";
    };
    EXPECT_EQ(triangles("m.dae", with(tetrahedron, scene, scene + camera(nowhere))), 4);
    EXPECT_EQ(triangles("m.dae", with(tetrahedron, scene, scene + camera("<matrix>1e30 0 0 0</matrix>"))), 4);
    EXPECT_EQ(triangles("m.dae", with(tetrahedron, "<node id=\"n\">", "<node id=\"n\">" + camera(nowhere))), 4);
    expectFault("m.dae", with(tetrahedron, "<node id=\"n\">", "<node id=\"n\">" + nowhere), "holds 'NaN', not a number");
    const std::string around = with(with(tetrahedron, scene, scene + "<node>" + nowhere), "</visual_scene>", "</node></visual_scene>");
    expectFault("m.dae", around, "holds 'NaN', not a number");
}

TEST_F(MeshCheck, ColladaOfAllKindsOfPolygons) {
    const std::string triangleList =
        "<triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 2 1 0 1 3 1 2 3 "
        "0 3 2</p></triangles>";
    const auto kind = [&](const std::string &name, const std::string &count, const std::string &inside) {
        return with(tetrahedron, triangleList,
                    "<" + name + " count=\"" + count +
                        "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>" + inside + "</" + name +
                        ">");
    };
    EXPECT_EQ(triangles("m.dae", kind("polylist", "2", "<vcount>3 4</vcount><p>0 2 1 0 1 3 2</p>")), 3);
    EXPECT_EQ(triangles("m.dae", kind("polygons", "2", "<p>0 2 1</p><p>0 1 3 2</p>")), 3);
    EXPECT_EQ(triangles("m.dae", kind("tristrips", "1", "<p>0 1 2 3 0</p>")), 3);
    EXPECT_EQ(triangles("m.dae", kind("trifans", "1", "<p>0 1 2 3</p>")), 2);
    expectFault("m.dae", kind("polylist", "2", "<vcount>3 5</vcount><p>0 2 1 0 1 3 2</p>"),
                "another number than it says");
    expectFault("m.dae", kind("polylist", "2", "<vcount>3 0</vcount><p>0 2 1</p>"), "a polygon of 0 corners");
    expectFault("m.dae", kind("polygons", "1", "<p>0 2 1</p><p>0 1 3 2</p>"), "another number than it says");
    expectFault("m.dae", kind("tristrips", "1", "<p>0 1</p>"), "has one of 2 corners");
    expectFault("m.dae", kind("lines", "1", "<p>0 1</p>"), "no triangles");
}

TEST_F(MeshCheck, ColladaWhoseNumbersLie) {
    const auto fault = [&](const std::string &from, const std::string &to, const std::string &reason) {
        expectFault("m.dae", with(tetrahedron, from, to), reason);
    };
    fault("count=\"12\"", "count=\"3\"", "holds 12 numbers and says that there are 3");
    fault("0 0 0 1 0 0 0 1 0 0 0 1", "0 0 0", "holds 3 numbers");
    fault("0 0 0 1 0 0", "0 0 0 1 0,5 0", "'0,5', not a finite number");
    fault("0 0 0 1 0 0", "0 0 0 nan 0 0", "'nan', not a finite number");
    fault("count=\"4\" stride", "count=\"5\" stride", "needs 15 numbers of 12");
    fault("count=\"4\" stride", "count=\"4000000000\" stride", "'4000000000' as 'count'");
    fault("count=\"4\" stride", "count=\"-1\" stride", "'-1' as 'count'");
    fault("stride=\"3\"", "stride=\"3\" offset=\"1000000\"", "needs 1000012 numbers of 12");
    fault("stride=\"3\"", "stride=\"3\" offset=\"-3\"", "'-3' as 'offset'");
    fault("stride=\"3\"", "stride=\"0\"", "no X, Y and Z within its stride");
    fault("stride=\"3\"", "stride=\"100\"", "needs 400 numbers of 12");
    fault("0 3 2</p>", "0 3 -1</p>", "'-1', not a whole number");
    fault("0 3 2</p>", "0 3 4</p>", "has a vertex 4 of 4");
    fault("0 3 2</p>", "0 3</p>", "another number than it says");
    fault("triangles count=\"4\"", "triangles count=\"5\"", "another number than it says");
    fault("source=\"#v\" offset=\"0\"", "source=\"#v\" offset=\"4\"", "belong together");
    fault("meter=\"1\"", "meter=\"x\"", "'x' as 'meter'");
    fault("meter=\"1\"", "meter=\"0\"", "'0' as 'meter'");
}

TEST_F(MeshCheck, ColladaWhoseReferencesLie) {
    const auto fault = [&](const std::string &from, const std::string &to, const std::string &reason) {
        expectFault("m.dae", with(tetrahedron, from, to), reason);
    };
    const std::string instance = "<instance_geometry url=\"#g\"/>";
    fault("url=\"#g\"", "url=\"#nothing\"", "names 'nothing', of which there is none");
    fault("url=\"#g\"", "url=\"other.dae#g\"", "not the id of an element of this file");
    fault("url=\"#s\"", "url=\"#g\"", "names 'g', of which there is none");
    fault("source=\"#a\"", "source=\"#p\"", "is not of the numbers of its source");
    fault("source=\"#p\"", "source=\"#v\"", "no <source> with id 'v'");
    fault("source=\"#v\"", "source=\"#p\"", "no <vertices> with id 'p'");
    fault(instance, "<instance_node url=\"#n\"/>" + instance, "within itself");
    fault(instance, "<node><instance_node url=\"#n\"/></node>" + instance, "within itself");
    fault(instance, "<instance_controller url=\"#c\"/>", "<instance_controller> in line 12 is not supported");
    fault(instance, "<matrix>1 0 0 0</matrix>" + instance, "has 4 numbers instead of 16");
    fault(instance, "<scale>1 1 inf</scale>" + instance, "'inf', not a number");
    fault("<scene>", "<scen>", "not well-formed XML");
    std::string deep, end;
    for (int i = 0; i < 20000; ++i) {
        deep += "<node>";
        end += "</node>";
    }
    fault(instance, deep + instance + end, "elements in one another");
    std::string doubling;  // 2^40 instances
    for (int i = 0; i < 40; ++i) {
        const std::string next = "<instance_node url=\"#d" + std::to_string(i + 1) + "\"/>";
        doubling += "<node id=\"d" + std::to_string(i) + "\">" + next + next + "</node>";
    }
    expectFault(
        "m.dae",
        with(with(tetrahedron, "<library_nodes>", "<library_nodes>" + doubling + "<node id=\"d40\"/>"),
             instance, "<instance_node url=\"#d0\"/>" + instance),
        "more than 100000 nodes");
}

TEST_F(MeshCheck, ObjWhoseFacesAndNumbersLie) {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1/1 2/1/1 4//1\nf -4 -1 \\\n-2\n";
    EXPECT_EQ(triangles("m.obj", obj), 3);
    EXPECT_EQ(triangles("m.obj", "mtllib none.mtl\n" + obj), 3);
    for (const char *const corner : {"0", "-5", "x", "1.5"})
        expectFault("m.obj", with(obj, "f 1 3 2", std::string("f 1 3 ") + corner),
                    "line 5: a face has no vertex");
    expectFault("m.obj", with(obj, "f 1 3 2", "f 1 3 9"), "a face has a vertex 9 of 4");
    expectFault("m.obj", with(obj, "v 1 0 0", "v 1,5 0 0"), "line 2: '1,5' is not a finite number");
    expectFault("m.obj", with(obj, "v 1 0 0", "v 1 0"), "line 2: a vertex has 2 coordinates");
    expectFault("m.obj", with(obj, "v 1 0 0", "v 1e39 0 0"), "not finite");
    std::string polygon = "f";
    for (int i = 0; i < 90000; ++i) polygon += " " + std::to_string(i % 4 + 1);
    expectFault("m.obj", obj + polygon + "\n", "line 9: a face has more than 1000 corners");
}

TEST_F(MeshCheck, StlWhoseFacetsAreNoTriangles) {
    const std::string facet =
        "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const std::string stl = "solid x\n" + facet + "endsolid x\n";
    EXPECT_EQ(triangles("m.stl", stl + stl), 2);
    EXPECT_EQ(triangles("M.STL", stl), 1);
    expectFault("m.stl", with(stl, "vertex 1 0 0\n", "vertex 1 0 0\nvertex 2 2 2\n"),
                "has 'vertex' where 'endloop'");
    expectFault("m.stl", with(stl, "vertex 1 0 0\n", ""), "has 'endloop' where 'vertex'");
    expectFault("m.stl", with(stl, "vertex 1", "vertex foo"), "has 'foo' where a finite number");
    expectFault("m.stl", with(stl, "vertex 1", "vertex inf"), "has 'inf' where a finite number");
    expectFault("m.stl", "solid x\n" + facet, "ends where 'endsolid'");

    std::string binary(80, ' ');
    const std::uint32_t count = 1;
    binary.append(reinterpret_cast<const char *>(&count), 4);
    const float triangle[12] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    binary.append(reinterpret_cast<const char *>(triangle), sizeof triangle).append(2, '\0');
    EXPECT_EQ(triangles("m.stl", binary), 1);
    expectFault("m.stl", binary + "x", "where 'solid' has to be; it is no binary STL either");
    expectFault("m.stl", binary.substr(0, binary.size() - 20), "it is no binary STL either");
}

}  // namespace
