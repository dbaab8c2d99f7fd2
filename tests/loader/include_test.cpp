// <include> at any depth: what is included is in the scene, or the error says why not.
#include "small_world.h"
#include "test_folder.h"

namespace {

using namespace small_world;

std::string modelFile(const std::string &name, const std::string &inside) {
    return "<sdf version=\"1.9\"><model name=\"" + name + "\">" + inside + "</model></sdf>";
}
std::string include(const std::string &uri, const std::string &more = "") {
    return "<include><uri>" + uri + "</uri>" + more + "</include>";
}
std::string ballOf(double radius) {
    return linkOf1kg("l", "0 0 0 0 0 0",
                     "<collision name=\"c\"><geometry>" + sphere(radius) + "</geometry></collision>");
}

class Include : public testing::Test {
protected:
    std::unique_ptr<worlds::SdfScene> loadInside(const std::string &inside) const {
        return worlds::loadWorldText(world(inside), folder.path("test.sdf"));
    }
    void expectMessage(const std::string &inside, const std::vector<std::string> &parts) const {
        try {
            loadInside(inside);
            ADD_FAILURE() << "loaded " << inside;
        } catch (const worlds::LoadError &error) {
            for (const std::string &part : parts)
                EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
                    << error.what() << "\n  does not say " << part;
        }
    }

    TestFolder folder{"include_test"};
};

TEST_F(Include, NestedOnesReachTheScene) {
    folder.write("inner.sdf", modelFile("inner", ballOf(0.5)));
    folder.write("middle.sdf",
                 modelFile("middle", ballOf(1) + include("inner.sdf", "<pose>0 0 3 0 0 0</pose>")));
    folder.write("outer.sdf", modelFile("outer", ballOf(2) + include("middle.sdf")));
    const auto scene = loadInside(include("outer.sdf", "<name>all</name>"));
    EXPECT_EQ(scene->bodyNames(),
              (std::vector<std::string>{"all::l", "all::middle::l", "all::middle::inner::l"}));
    EXPECT_NEAR(position(body(*scene, "all::middle::inner::l")).z, 3, 1e-12);
    EXPECT_EQ(dGeomSphereGetRadius(geom(*scene, "all::middle::inner::l::c")), 0.5);
}

TEST_F(Include, RelativeNamesAreThoseOfTheFileThatNamesThem) {
    folder.write("sub/mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder.write("sub/part.sdf",
                 modelFile("part",
                           "<link name=\"l\"><collision name=\"c\"><geometry><mesh><uri>mesh.obj</uri>"
                           "</mesh></geometry></collision></link>"));
    folder.write("sub/whole.sdf", modelFile("whole", ballOf(1) + include("part.sdf")));
    const auto scene = loadInside(include("sub/whole.sdf"));
    EXPECT_EQ(dGeomGetClass(geom(*scene, "whole::part::l::c")), dTriMeshClass);
}

TEST_F(Include, OfAFolderOneModelManyTimes) {
    folder.write("models/ball/model.config",
                 "<model><name>ball</name><sdf version=\"1.9\">model.sdf</sdf></model>");
    folder.write("models/ball/model.sdf", modelFile("ball", ballOf(1)));
    std::string inside;
    for (int i = 0; i < 20; ++i) inside += include("model://ball", "<name>b" + std::to_string(i) + "</name>");
    EXPECT_EQ(loadInside(inside)->inventory().bodies.size(), 20u);
}

TEST_F(Include, ThatIsMissingWithinAnIncludedModelIsAnError) {
    const std::string file =
        folder.write("outer.sdf", modelFile("outer", ballOf(1) + include("nothing.sdf")));
    expectMessage(include("outer.sdf"),
                  {file + ": /sdf/world/model[outer]/include/uri: no model 'nothing.sdf'"});
}

TEST_F(Include, OfItselfIsAnError) {
    folder.write("self.sdf", modelFile("self", ballOf(1) + include("self.sdf")));
    expectMessage(include("self.sdf"), {"self.sdf: /sdf/world/model[self]/include/uri: ", "includes itself"});
    folder.write("a.sdf", modelFile("a", ballOf(1) + include("b.sdf")));
    folder.write("b.sdf", modelFile("b", ballOf(1) + include("a.sdf")));
    expectMessage(include("a.sdf"), {"b.sdf: /sdf/world/model[a]/model[b]/include/uri: ", "includes itself"});
}

TEST_F(Include, IsNestedFiftyDeepAtMostAndHasAnEnd) {
    folder.write("m0.sdf", modelFile("m0", ballOf(1)));
    for (int i = 1; i < 60; ++i) {
        const std::string inner = "m" + std::to_string(i - 1) + ".sdf";
        folder.write("m" + std::to_string(i) + ".sdf",
                     modelFile("m" + std::to_string(i), ballOf(1) + include(inner)));
    }
    expectMessage(include("m59.sdf"), {"nested more than 50 deep"});
    folder.write("n0.sdf", modelFile("n0", ballOf(1)));
    for (int i = 1; i < 40; ++i) {
        const std::string inner = "n" + std::to_string(i - 1) + ".sdf";
        folder.write("n" + std::to_string(i) + ".sdf",
                     modelFile("n" + std::to_string(i), ballOf(1) + include(inner, "<name>x</name>") +
                                                            include(inner, "<name>y</name>")));
    }
    expectMessage(include("n39.sdf"), {"includes more than 20000 models"});
}

TEST_F(Include, OfWhatIsNoModelIsAnError) {
    folder.write("world.sdf", world(""));
    expectMessage(include("world.sdf"), {"world.sdf: /sdf/world: not supported"});
    folder.write("two.sdf", "<sdf version=\"1.9\"><model name=\"a\"/><model name=\"b\"/></sdf>");
    expectMessage(include("two.sdf"), {"two.sdf: /sdf: an included file that does not hold one <model>"});
    folder.write("broken.sdf", "<sdf version=\"1.9\"><model");
    expectMessage(include("broken.sdf"), {"broken.sdf: not well-formed XML, line 1"});
    folder.write("old.sdf", "<sdf version=\"99.0\"><model name=\"m\"><link name=\"l\"/></model></sdf>");
    expectMessage(include("old.sdf"), {"old.sdf: /sdf: version '99.0'"});
    folder.write("empty.sdf", "");
    expectMessage(include("empty.sdf"), {"test.sdf: /sdf/world/include/uri: ", "empty.sdf: is empty"});
    folder.write("bare/other", "");
    expectMessage(include("bare"), {"test.sdf: /sdf/world/include/uri: model 'bare': ", "model.config"});
}

TEST_F(Include, OfALightOrAnActorIsLeftAside) {
    folder.write("walker.sdf", "<sdf version=\"1.6\"><actor name=\"walker\"/></sdf>");
    folder.write("sun.sdf", "<sdf version=\"1.6\"><light name=\"sun\" type=\"directional\"/></sdf>");
    folder.write("ball.sdf", modelFile("ball", ballOf(1)));
    EXPECT_EQ(loadInside(include("sun.sdf") + include("walker.sdf") + include("ball.sdf"))->bodyNames(), std::vector<std::string>{"ball::l"});
}

TEST_F(Include, OfAPartThatIsPlacedNeedsAPose) {
    folder.write("ball.sdf", modelFile("ball", ballOf(1)));
    expectMessage(include("ball.sdf", "<placement_frame>l</placement_frame>"),
                  {"test.sdf: /sdf/world/include/placement_frame: needs a <pose> beside it"});
}

TEST_F(Include, HoldsNothingElse) {
    folder.write("ball.sdf", modelFile("ball", ballOf(1)));
    expectMessage(include("ball.sdf", "<name>a::b</name>"), {"/sdf/world/include/name: a name may not hold '::'"});
    for (const char *const inside : {"<self_collide>1</self_collide>", "<link name=\"x\"/>", "<foo/>", "<odemt:x/>"}) {
        expectMessage(include("ball.sdf", inside), {"test.sdf", "/sdf/world/include/", "not supported"});
        folder.write("outer.sdf", modelFile("outer", include("ball.sdf", inside)));
        expectMessage(include("outer.sdf"), {"outer.sdf", "include/", "not supported"});
    }
}

// Which file describes a model that is a folder.
TEST_F(Include, UnknownAttributesOfTheModelAreErrors) {
    for (const char *const version : {"1.5", "1.9"}) {
        folder.write("part.sdf", "<sdf version=\"" + std::string(version) + "\"><model name=\"part\" weight=\"2\"><link name=\"l\"/></model></sdf>");
        expectMessage(include("part.sdf"), {folder.path("part.sdf") + ": /sdf/world/model[part]: attribute 'weight': not supported"});
    }
}

TEST_F(Include, TheModelsFolderNamesItsFile) {
    folder.write("robot/new.sdf", modelFile("robot", ballOf(1)));
    folder.write("robot/old.sdf", modelFile("older", ballOf(2)));
    const auto config = [&](const std::string &inside) { folder.write("robot/model.config", inside); };
    config("<model><sdf version=\"1.6\">old.sdf</sdf><sdf version=\"1.9\"> new.sdf\n</sdf><sdf "
           "version=\"1.5\">none.sdf</sdf><sdf version=\"9.9\">none.sdf</sdf></model>");
    EXPECT_EQ(loadInside(include("robot"))->bodyNames(), (std::vector<std::string>{"robot::l"}));
    config("<model><sdf>new.sdf</sdf></model>");
    EXPECT_EQ(loadInside(include("robot"))->bodyNames(), (std::vector<std::string>{"robot::l"}));
    for (const char *const inside :
         {"<model/>", "<model><sdf/></model>",
          "<model><sdf version=\"9.9\">new.sdf</sdf></model>", "<model><sdf version=\"abc\">new.sdf</sdf></model>",
          "<model><sdf version=\"1.9\"></sdf></model>", "<model><SDF version=\"1.9\">new.sdf</SDF></model>",
          "<sdf version=\"1.9\">new.sdf</sdf>", "<model>", ""}) {
        config(inside);
        expectMessage(include("robot"), {"test.sdf: /sdf/world/include/uri", "robot/model.config: "});
    }
}

}  // namespace
