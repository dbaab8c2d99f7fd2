// Small files, each with one peculiarity of files that were written for Gazebo: whether it loads, with which warnings, and
// what becomes of it when what is not supported is left out.
#include "small_world.h"
#include "test_folder.h"

#include "loader/load_world.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace {

using namespace small_world;
namespace fs = std::filesystem;

struct File {
    const char *name;
    const char *warning = "";  // part of the one warning of it as it is; empty: none
    const char *refusal = "";  // part of the message; empty: it loads as it is
};
void PrintTo(const File &file, std::ostream *out) { *out << file.name; }

const File kFiles[] = {
    {"actor.sdf"},
    {"axis_of_ball_joint.sdf", "/joint[held]/axis: left aside: a joint of this type has none"},
    {"blank_lines_before_declaration.sdf", "not well-formed XML, line 3: the declaration <?xml is not at the very beginning"},
    {"cdata_in_world.sdf"},
    {"comment_before_declaration.sdf", "not well-formed XML, line 2: the declaration <?xml is not at the very beginning"},
    {"contact_defaults.sdf"},
    {"empty_pose.sdf"},
    {"foreign_namespace.sdf"},
    {"fuel_model.sdf", "", "no model 'https://fuel.gazebosim.org/1.0/Nobody/models/No such model': nothing is fetched"},
    {"hexadecimal_bitmask.sdf"},
    {"hyphens_in_comment.sdf", "not well-formed XML, line 4: a comment holds '--'"},
    {"ignored_engine.sdf"},
    {"impossible_inertia.sdf", "/inertial/inertia: no body has such an inertia matrix"},
    {"included_sun.sdf"},
    {"known_model_plugin.sdf"},
    {"model_alone.sdf"},
    {"model_plugin_1.7.sdf", "", "/plugin[gz::sim::systems::Unknown]: filename 'libunknown.so', which may move something"},
    {"model_plugin_1.8.sdf", "", "/plugin[gz::sim::systems::Unknown]: filename 'libunknown.so', which may move something"},
    {"model_plugin_1.9.sdf", "", "/plugin[gz::sim::systems::Unknown]: filename 'libunknown.so', which may move something"},
    {"no_contacts.sdf"},
    {"saved_state.sdf", "/sdf/world/state: left aside: models start where <model> says"},
    {"shape_without_size.sdf"},
    {"static_without_mass.sdf"},
    {"torsional_defaults.sdf"},
    {"unlimited_friction.sdf"},
    {"version_1.10.sdf"},
    {"version_1.11.sdf"},
    {"version_1.12.sdf"},
    {"world_plugin.sdf"},
    {"written_twice.sdf", "/link[body]/velocity_decay: is written twice: the first one counts"},
};

std::string path(const std::string &name) { return std::string(LOADER_FILES) + "/" + name; }

class FilesOfGazebo : public testing::TestWithParam<File> {
protected:
    Loaded load(bool ignoreUnsupported) const {
        Loaded loaded;
        worlds::LoadOptions options;
        options.ignoreUnsupported = ignoreUnsupported;
        options.ignoringOption = "--leave-out";
        options.warnings = &loaded.warnings;
        loaded.scene = worlds::loadWorld(path(GetParam().name), options);
        return loaded;
    }
    // The ball is there and can move.
    static void expectTheBall(const Loaded &loaded) {
        EXPECT_NO_THROW(body(*loaded.scene, "ball::body"));
        run(*loaded.scene, 10);
        EXPECT_TRUE(isFinite(*loaded.scene));
    }
};

void expectOne(const std::vector<std::string> &warnings, const std::string &part) {
    ASSERT_EQ(warnings.size(), part.empty() ? 0u : 1u) << (warnings.empty() ? "" : warnings[0]);
    for (const std::string &warning : warnings) EXPECT_NE(warning.find(part), std::string::npos) << warning;
}

TEST_P(FilesOfGazebo, AsTheyAre) {
    const std::string refusal = GetParam().refusal;
    try {
        const Loaded loaded = load(false);
        EXPECT_TRUE(refusal.empty()) << "loaded";
        expectTheBall(loaded);
        expectOne(loaded.warnings, GetParam().warning);
    } catch (const worlds::LoadError &error) {
        EXPECT_FALSE(refusal.empty()) << error.what();
        EXPECT_NE(std::string(error.what()).find(refusal), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("; --leave-out leaves it out"), std::string::npos) << error.what();
    }
}

TEST_P(FilesOfGazebo, WithoutWhatIsNotSupported) {
    const Loaded loaded = load(true);
    expectTheBall(loaded);
    const std::string refusal = GetParam().refusal;
    expectOne(loaded.warnings, refusal.empty() ? GetParam().warning : refusal.substr(0, refusal.find("; --leave-out")));
    if (refusal.empty()) return;
    EXPECT_NE(loaded.warnings.at(0).find("; left out"), std::string::npos) << loaded.warnings[0];
}

INSTANTIATE_TEST_SUITE_P(Each, FilesOfGazebo, testing::ValuesIn(kFiles), [](const auto &info) {
    std::string name = fs::path(info.param.name).stem();
    for (char &c : name)
        if (c == '.') c = '_';
    return name;
});

TEST(FilesOfGazeboFolder, HasNoOthers) {
    std::set<std::string> tested, found;
    for (const File &file : kFiles) tested.insert(file.name);
    for (const fs::directory_entry &entry : fs::directory_iterator(LOADER_FILES)) found.insert(entry.path().filename());
    EXPECT_EQ(tested, found);
}

// ---- what the files alone do not show

TEST(ModelAlone, StandsOnAPlane) {
    const auto scene = worlds::loadWorld(path("model_alone.sdf"));
    EXPECT_EQ(dGeomGetClass(geom(*scene, "ground_plane::link::collision")), dPlaneClass);
    runFor(*scene, 1);
    EXPECT_NEAR(position(body(*scene, "ball::body")).z, 0.5, 0.01);
}

TEST(ModelAlone, IsNamedByWhatIsInTheFile) {
    expectError("<sdf version=\"1.6\"><model name=\"m\"><link name=\"l\"/><pose>x</pose></model></sdf>",
                worlds::LoadError::Kind::Value, {"test.sdf: /sdf/model[m]/pose: 'x' is not a number"});
}

TEST(ModelAlone, MayBeTheGround) {
    const auto scene = load("<sdf version=\"1.6\">" + staticModel("ground_plane", "0 0 0 0 0 0", "<plane/>") + "</sdf>");
    EXPECT_EQ(scene->inventory().geoms.size(), 1u);
}

TEST(ModelAlone, IsOne) {
    const std::string model = "<model name=\"m\"><link name=\"l\"/></model>";
    expectError("<sdf version=\"1.6\">" + model + model + "</sdf>", worlds::LoadError::Kind::Syntax,
                {"holds neither a <world> nor one <model>"});
}

// Sizes are SDF's defaults.
TEST(ShapesWithoutSizes, HaveSdfsDefaults) {
    const auto shapeOf = [](const std::string &geometry) { return load(world(model("m", "0 0 0 0 0 0", geometry))); };
    const std::string name = "m::link::shape";
    EXPECT_EQ(dGeomSphereGetRadius(geom(*shapeOf("<sphere/>"), name)), 1);
    dVector3 sides;
    dGeomBoxGetLengths(geom(*shapeOf("<box/>"), name), sides);
    EXPECT_EQ((Vector3{sides[0], sides[1], sides[2]}), (Vector3{1, 1, 1}));
    dReal radius, length;
    dGeomCylinderGetParams(geom(*shapeOf("<cylinder/>"), name), &radius, &length);
    EXPECT_EQ(radius, 1);
    EXPECT_EQ(length, 1);
    dGeomCapsuleGetParams(geom(*shapeOf("<capsule/>"), name), &radius, &length);
    EXPECT_EQ(radius, 0.5);
    EXPECT_EQ(length, 1);
}

// ---- models that are fetched, or found

// Sets a variable for the time of a test.
class Variable {
public:
    Variable(const char *name, const std::string &value) : m_name(name) {
        if (const char *const old = std::getenv(name)) m_old = old, m_isSet = true;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { m_isSet ? ::setenv(m_name, m_old.c_str(), 1) : ::unsetenv(m_name); }
    Variable(const Variable &) = delete;
    Variable &operator=(const Variable &) = delete;

private:
    const char *m_name;
    std::string m_old;
    bool m_isSet = false;
};

class FoundModels : public testing::Test {
protected:
    void writeModel(const std::string &model, const std::string &link) const {
        folder.write(model + "/model.config", "<model><sdf version=\"1.6\">model.sdf</sdf></model>");
        folder.write(model + "/model.sdf", "<sdf version=\"1.6\"><model name=\"found\"><link name=\"" + link + "\"/></model></sdf>");
    }
    std::vector<std::string> bodiesOf(const std::string &uri) const {
        return load(world("<include><uri>" + uri + "</uri></include>"))->bodyNames();
    }

    TestFolder folder{"found_models"};
};

TEST_F(FoundModels, AreTheNewestThatGazeboHasFetched) {
    const Variable home("HOME", folder.path(""));
    const std::string models = ".gz/fuel/fuel.gazebosim.org/openrobotics/models/";
    writeModel(models + "my ball/2", "second");
    writeModel(models + "my ball/10", "tenth");
    const std::string url = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/";
    const std::vector<std::string> tenth = {"found::tenth"}, second = {"found::second"};
    EXPECT_EQ(bodiesOf(url + "My Ball"), tenth);
    EXPECT_EQ(bodiesOf(url + "My%20Ball"), tenth);
    EXPECT_EQ(bodiesOf(url + "My%20Ball/tip"), tenth);
    EXPECT_EQ(bodiesOf(url + "My%20Ball/2"), second);
    EXPECT_EQ(bodiesOf(url + "My%20Ball/2/files/model.sdf"), second);
    EXPECT_EQ(bodiesOf("https://fuel.ignitionrobotics.org/1.0/openrobotics/models/my ball"), tenth);
    for (const char *const other : {"My Ball/3", "Ball", "../models/My Ball", "My Ball/2/files/../../10/model.sdf"})
        EXPECT_THROW(bodiesOf(url + other), worlds::LoadError) << other;
}

TEST_F(FoundModels, OfGazeboItselfAreOursIfNothingWasFetched) {
    const Variable home("HOME", folder.path(""));
    EXPECT_TRUE(bodiesOf("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun").empty());
    const auto scene = load(world("<include><uri>https://fuel.ignitionrobotics.org/1.0/OpenRobotics/models/Ground Plane</uri></include>"));
    EXPECT_EQ(dGeomGetClass(geom(*scene, "ground_plane::link::collision")), dPlaneClass);
    EXPECT_THROW(bodiesOf("https://fuel.gazebosim.org/1.0/Somebody/models/Sun"), worlds::LoadError);
    EXPECT_THROW(bodiesOf("https://fuel.gazebosim.org/1.0/OpenRobotics/models/epuck"), worlds::LoadError);
    writeModel(".gz/fuel/fuel.gazebosim.org/openrobotics/models/sun/1", "fetched");
    EXPECT_EQ(bodiesOf("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun"), std::vector<std::string>{"found::fetched"});
}

TEST_F(FoundModels, AreThoseOfOlderReleases) {
    const Variable home("HOME", folder.path(""));
    writeModel(".ignition/fuel/fuel.ignitionrobotics.org/somebody/models/ball/1", "old");
    EXPECT_EQ(bodiesOf("https://fuel.gazebosim.org/1.0/Somebody/models/Ball"), std::vector<std::string>{"found::old"});
}

TEST_F(FoundModels, StandInFoldersOfVariables) {
    for (const char *const variable : {"SDF_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH"}) {
        const std::string model = std::string("of_") + variable;
        writeModel("folder/" + model, "l");
        EXPECT_THROW(bodiesOf("model://" + model), worlds::LoadError);
        const Variable set(variable, "/nowhere:" + folder.path("folder"));
        EXPECT_EQ(bodiesOf("model://" + model), std::vector<std::string>{"found::l"});
    }
}

TEST_F(FoundModels, OfTheUserComeBeforeOurs) {
    writeModel("folder/ground_plane", "own");
    const Variable set("GAZEBO_MODEL_PATH", folder.path("folder"));
    EXPECT_EQ(bodiesOf("model://ground_plane"), std::vector<std::string>{"found::own"});
}

TEST_F(FoundModels, WhenMissingSayWhereTheyWereLookedFor) {
    const Variable set("GAZEBO_MODEL_PATH", "/my/models");
    const auto messageOf = [](const std::string &inside) {
        try {
            load(world(inside));
        } catch (const worlds::LoadError &error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (const auto &[inside, text] :
         {std::pair("<include><uri>model://q</uri></include>", "/sdf/world/include/uri: no model 'model://q': "),
          std::pair("<model name=\"m\"><link name=\"l\"><collision name=\"c\"><geometry><mesh><uri>model://q/a.stl</uri></mesh>"
                    "</geometry></collision></link></model>",
                    "/mesh: no file 'model://q/a.stl': ")}) {
        const std::string message = messageOf(inside);
        EXPECT_NE(message.find(text), std::string::npos) << message;
        for (const char *const part : {"the current folder", "models", "/my/models", "; SDF_PATH, GZ_SIM_RESOURCE_PATH, "
                                       "IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH name further folders"})
            EXPECT_NE(message.find(part), std::string::npos) << message;
        EXPECT_NE(message.find(worlds::commonModelFolder()), std::string::npos) << message;
    }
}

// A file that is missing or broken is left out as what is not supported is.
TEST_F(FoundModels, MayBeMissingOrBroken) {
    folder.write("broken.obj", "v 1 2 x\nf 1 1 1\n");
    folder.write("part.sdf", "<sdf version=\"1.6\"><model name=\"part\"><link name=\"l\"><collision name=\"c\"><geometry><mesh>"
                             "<uri>nothing.obj</uri></mesh></geometry></collision></link></model></sdf>");
    const std::string mesh = "<mesh><uri>" + folder.path("broken.obj") + "</uri></mesh>";
    const Loaded loaded =
        loadWithWarnings(world(model("m", "0 0 0 0 0 0", mesh) + "<include><uri>" + folder.path("part.sdf") +
                               "</uri></include><include><uri>model://nothing</uri></include>"),
                         true);
    EXPECT_EQ(loaded.scene->bodyNames(), (std::vector<std::string>{"m::link", "part::l"}));
    EXPECT_TRUE(loaded.scene->inventory().geoms.empty());
    EXPECT_EQ(loaded.warnings.size(), 3u);
}

// ---- what is left out inline is left out in an included file, too

TEST_F(FoundModels, HoldWhatIsLeftOutInline) {
    const std::string bodyOf = linkOf1kg("l", "0 0 0 0 0 0",
                                         "<enable_wind>true</enable_wind><collision name=\"c\"><geometry><ellipsoid/></geometry>"
                                         "</collision>"),
                      joint = "<joint name=\"j\" type=\"screw\"><parent>world</parent><child>l</child></joint>",
                      plugin = "<plugin name=\"p\" filename=\"libother.so\"/>", gripper = "<gripper name=\"g\"/>";
    const std::string model = "<model name=\"m\">" + bodyOf + joint + plugin + gripper + "</model>";
    folder.write("part.sdf", "<sdf version=\"1.6\">" + model + "</sdf>");
    for (const char *const other : {"<model name=\"a\"/><model name=\"b\"/>", "<robot name=\"a\"/>", "<world name=\"w\"/>"})
        folder.write(std::string("other") + other[1] + ".sdf", "<sdf version=\"1.6\">" + std::string(other) + "</sdf>");
    folder.write("new.sdf", "<sdf version=\"1.99\"><model name=\"n\"/></sdf>");
    const auto include = [&](const std::string &file) { return "<include><uri>" + folder.path(file) + "</uri></include>"; };
    const Loaded inlined = loadWithWarnings(world(model), true), included = loadWithWarnings(world(include("part.sdf")), true);
    EXPECT_EQ(inlined.warnings.size(), 5u);
    EXPECT_EQ(included.warnings.size(), inlined.warnings.size());
    EXPECT_EQ(included.scene->bodyNames(), inlined.scene->bodyNames());
    for (const char *const file : {"otherm.sdf", "otherr.sdf", "otherw.sdf", "new.sdf"}) {
        EXPECT_THROW(load(world(include(file))), worlds::LoadError) << file;
        const Loaded without = loadWithWarnings(world(include(file)), true);
        EXPECT_EQ(without.warnings.size(), 1u) << file;
        EXPECT_TRUE(without.scene->inventory().bodies.empty());
    }
}

// ---- plugins

std::string plugged(const std::string &file, const std::string &inside = "", const std::string &name = "p") {
    return world("<model name=\"m\"><link name=\"l\"/><plugin name=\"" + name + "\" filename=\"" + file + "\">" + inside + "</plugin></model>");
}

TEST(Plugins, ThatMoveNothingAreLeftAside) {
    for (const char *const file :
         {"gz-sim-imu-system", "libgz-sim-imu-system.so", "gz-sim8-imu-system", "ignition-gazebo-imu-system",
          "libignition-gazebo6-imu-system.so", "libgazebo_ros_imu.so", "gz-sim-log-system"}) {
        EXPECT_TRUE(loadWithWarnings(plugged(file)).warnings.empty()) << file;
        EXPECT_TRUE(loadWithWarnings(world("<plugin name=\"p\" filename=\"" + std::string(file) + "\"/>")).warnings.empty()) << file;
    }
    EXPECT_TRUE(loadWithWarnings(plugged("dummy", "<performer name=\"p\"/>", "gz::sim")).warnings.empty());
    EXPECT_THROW(load(plugged("gz-sim-log-system", "", "gz::sim::systems::LogPlayback")), worlds::LoadError);
}

TEST(Plugins, ThatAwaitMessagesAreLeftAsideWithAWarning) {
    for (const char *const file : {"gz-sim-diff-drive-system", "libignition-gazebo-thruster-system.so", "libgazebo_ros_diff_drive.so"}) {
        const std::vector<std::string> warnings = loadWithWarnings(plugged(file)).warnings;
        ASSERT_EQ(warnings.size(), 1u) << file;
        EXPECT_EQ(warnings[0].find("test.sdf: /sdf/world/model[m]/plugin[p]: filename '" + std::string(file) + "': left aside: "), 0u)
            << warnings[0];
    }
    EXPECT_THROW(load(plugged("gz-sim-velocity-control-system", "<initial_linear>1 0 0</initial_linear>")), worlds::LoadError);
}

TEST(Plugins, ThatAreNotKnownMayMoveSomething) {
    for (const char *const file : {"gz-sim-buoyancy-system", "imu", "gz-sim-imu", "gz-simimu-system", "gz-sim-x-system", "libx.so", "lib.so", ".so",
                                   "gz-sim--system", "gz-sim", "libgz-sim", "odemt-nothing"})
        expectError(plugged(file), worlds::LoadError::Kind::Unsupported, {"plugin[p]: filename '" + std::string(file) + "', which may move"});
}

}  // namespace
