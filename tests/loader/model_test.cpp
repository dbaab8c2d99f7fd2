// Models: their poses, their contents, and what is common to their links.
#include "small_world.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace {

using namespace small_world;

TEST(Model, PosesAddUpThroughModelsAndLinks) {
    const auto scene = load(world(R"(
      <model name="outer"><pose>1 0 0 0 0 1.5707963267948966</pose>)" +
                                  linkOf1kg("base", "0 0 0 0 0 0") + R"(
        <model name="inner"><pose>1 0 0 0 0 0</pose>)" +
                                  linkOf1kg("tip", "0 0 1 0 0 0") + R"(</model>
        <joint name="j" type="fixed"><parent>base</parent><child>inner::tip</child></joint>
      </model>)"));
    EXPECT_LT((position(body(*scene, "outer::inner::tip")) - Vector3{1, 1, 1}).length(), 1e-9);
    EXPECT_EQ(dJointGetBody(joint(*scene, "outer::j"), 0), body(*scene, "outer::inner::tip"));
}

TEST(Model, PosesMayBeRelativeToFrames) {
    const auto scene = load(world(R"(
      <frame name="table"><pose>0 0 0.75 0 0 0</pose></frame>
      <model name="m"><pose relative_to="table">1 0 0 0 0 0</pose>
        <frame name="shelf"><pose degrees="true">0 0 0.5 0 0 90</pose></frame>
        <link name="link"><pose relative_to="shelf">1 0 0 0 0 0</pose></link>
      </model>)"));
    EXPECT_LT((position(body(*scene, "m::link")) - Vector3{1, 1, 1.25}).length(), 1e-9);
}

TEST(Model, AnEmptyPoseChangesNothing) {
    for (const char *const pose : {"<pose/>", "<pose> </pose>", "<pose degrees=\"true\"></pose>"})
        EXPECT_EQ(position(body(*load(world("<model name=\"m\">" + std::string(pose) + "<link name=\"l\"/></model>")), "m::l")),
                  Vector3());
}

TEST(Model, PlacementFrameIsTheOneThatIsPlaced) {
    const auto scene =
        load(world("<model name=\"m\" placement_frame=\"tip\"><pose>0 0 1 0 0 0</pose>" +
                   linkOf1kg("base", "0 0 0 0 0 0") + linkOf1kg("tip", "0 0 3 0 0 0") + "</model>"));
    EXPECT_NEAR(position(body(*scene, "m::base")).z, -2, 1e-9);
}

TEST(Model, StaticModelsHaveNoBodies) {
    const auto scene = load(world(staticModel("m", "1 2 3 0 0 0", box(1, 1, 1))));
    EXPECT_TRUE(scene->inventory().bodies.empty());
    EXPECT_EQ(dGeomGetPosition(geom(*scene, "m::link::shape"))[2], 3);
}

TEST(Model, ModelsInAStaticOneAreStatic) {
    const auto scene = load(world("<model name=\"outer\"><static>true</static>" +
                                  model("inner", "0 0 1 0 0 0", sphere(1)) + "</model>"));
    EXPECT_TRUE(scene->inventory().bodies.empty());
    EXPECT_EQ(scene->geomNames(), std::vector<std::string>{"outer::inner::link::shape"});
}

TEST(Model, LinksMayFloatAndBeKinematic) {
    const auto scene =
        load(world("<model name=\"m\">" + linkOf1kg("light", "0 0 0 0 0 0", "<gravity>false</gravity>") +
                   linkOf1kg("fixed", "0 0 0 0 0 0", "<kinematic>true</kinematic>") +
                   linkOf1kg("usual", "0 0 0 0 0 0") + "</model>"));
    EXPECT_TRUE(dBodyIsKinematic(body(*scene, "m::fixed")));
    runFor(*scene, 0.1);
    EXPECT_EQ(velocity(body(*scene, "m::light")).z, 0);
    EXPECT_EQ(velocity(body(*scene, "m::fixed")).z, 0);
    EXPECT_NEAR(velocity(body(*scene, "m::usual")).z, -0.98, 1e-9);
}

class Included : public testing::Test {
protected:
    void SetUp() override {
        namespace fs = std::filesystem;
        m_folder = fs::path(testing::TempDir()) / ("include_test_" + std::to_string(::getpid()));
        fs::create_directories(m_folder / "models/ball");
        std::ofstream(m_folder / "models/ball/model.config")
            << "<?xml version=\"1.0\"?><model><name>ball</name><sdf version=\"1.9\">model.sdf</sdf></model>";
        writeModel("");
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    void writeModel(const std::string &extra) const {
        std::ofstream(m_folder / "models/ball/model.sdf") << "<sdf version=\"1.9\"><model name=\"ball\">" +
                                                                 linkOf1kg("link", "0 0 1 0 0 0", extra) +
                                                                 "</model></sdf>";
    }
    std::unique_ptr<worlds::SdfScene> loadBeside(const std::string &inside) const {
        return worlds::loadWorldText(world(inside), m_folder / "test.sdf");
    }

    std::filesystem::path m_folder;
};

TEST_F(Included, IsFoundBesideTheWorld) {
    const auto scene = loadBeside(
        "<include><uri>model://ball</uri><name>first</name></include>"
        "<include><uri>model://ball</uri><name>second</name><pose>0 2 0 0 0 0</pose></include>");
    EXPECT_LT((position(body(*scene, "second::link")) - Vector3{0, 2, 1}).length(), 1e-9);
    EXPECT_LT((position(body(*scene, "first::link")) - Vector3{0, 0, 1}).length(), 1e-9);
}

TEST_F(Included, IsFoundInTheFoldersOfTheOptions) {
    worlds::LoadOptions options;
    options.modelFolders = {m_folder / "models"};
    const std::string sdf = world("<include><uri>model://ball</uri></include>");
    EXPECT_EQ(load(sdf, options)->inventory().bodies.size(), 1u);
    EXPECT_THROW(load(sdf), worlds::LoadError);
}

TEST_F(Included, NamesTheFileOfAnUnsupportedElement) {
    writeModel("<must_be_base_link>true</must_be_base_link>");
    try {
        loadBeside("<include><uri>model://ball</uri><name>mine</name></include>");
        FAIL();
    } catch (const worlds::LoadError &error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("models/ball/model.sdf: "), std::string::npos) << message;
        EXPECT_NE(message.find("/model[mine]/link[link]/must_be_base_link: not supported"), std::string::npos)
            << message;
    }
}

}  // namespace
