// Every message names file, element and reason, and shows no control characters.
#include "small_world.h"

namespace {

using namespace small_world;

struct Case {
    const char *name;
    std::string sdf, begin, reason;
};
void PrintTo(const Case &message, std::ostream *out) { *out << message.name; }

class Message : public testing::TestWithParam<Case> {};

TEST_P(Message, NamesFileElementAndReason) {
    try {
        load(GetParam().sdf);
        ADD_FAILURE() << "loaded";
    } catch (const worlds::LoadError &error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find("test.sdf: " + GetParam().begin + ": "), 0u) << what;
        EXPECT_NE(what.find(GetParam().reason), std::string::npos) << what;
    }
}

std::string robot(const std::string &inside) {
    return world("<model name=\"m\"><link name=\"a\"/><link name=\"b\"/>" + inside + "</model>");
}
std::string joint(const std::string &inside) {
    return robot("<joint name=\"j\" type=\"revolute\"><parent>a</parent>" + inside + "</joint>");
}
std::string versioned(const std::string &version) {
    return "<sdf version=\"" + version + "\"><world name=\"w\"/></sdf>";
}

const std::string m = "/sdf/world/model[m]";

INSTANTIATE_TEST_SUITE_P(
    Of, Message,
    testing::Values(
        Case{"frameCycle",
             robot("<frame name=\"f\" attached_to=\"g\"/><frame name=\"g\" attached_to=\"f\"/>"),
             m + "/frame[f]", "cycle"},
        Case{"frameOfALinksName", robot("<frame name=\"a\"/>"), m + "/frame[a]", "a <link> is called 'a', too"},
        Case{"frameThatIsNot", robot("<frame name=\"f\"><pose relative_to=\"q\">0 0 0 0 0 0</pose></frame>"),
             m + "/frame[f]/pose", "relative_to: no frame 'q' in the model 'm'"},
        Case{"jointTwice",
             robot("<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"
                   "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>"),
             m + "/joint[j]", "a second <joint>"},
        Case{"childThatIsNot", joint("<child>q</child><axis><xyz>0 0 1</xyz></axis>"), m + "/joint[j]/child",
             "no frame 'q' in the model 'm'"},
        Case{"jointWithoutAxis", joint("<child>b</child>"), m + "/joint[j]", "needs <axis>"},
        Case{"linkWithoutName", world("<model name=\"m\"><link/></model>"), m + "/link",
             "needs an attribute 'name'"},
        Case{"reservedName", world("<model name=\"m\"><link name=\"__a__\"/></model>"), m + "/link[__a__]",
             "the name '__a__' is reserved"},
        Case{"partedName", world("<model name=\"m\"><link name=\"a::b\"/></model>"), m + "/link[a::b]",
             "'::'"},
        Case{"inertia",
             robot("<link name=\"c\"><inertial><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>5</ixy></inertia>"
                   "</inertial></link>"),
             m + "/link[c]/inertial/inertia", "the inertia matrix is not positive definite"},
        Case{"attribute", world("<model name=\"m\" weight=\"2\"><link name=\"l\"/></model>"), m,
             "attribute 'weight'"},
        Case{
            "controlCharacters",
            world(
                "<model name=\"m&#127;[31m&#10;\xe2\x80\xae\"><link name=\"l\"/><pose>&#x85;</pose></model>"),
            "/sdf/world/model[m\\x7f[31m\\x0a\\xe2\\x80\\xae]/pose", "'\\xc2\\x85'"},
        Case{"version99", versioned("99.0"), "/sdf", "version '99.0': not supported; 1.2 to 1.12 are"},
        Case{"versionBelow0", versioned("-1"), "/sdf", "version '-1'"},
        Case{"versionEmpty", versioned(""), "/sdf", "version ''"},
        Case{"longName", world("<model name=\"" + std::string(30000, 'x') + "\"><link name=\"l\"/></model>"),
             "/sdf/world/model[" + std::string(83, 'x') + "..." + std::string(99, 'x') + "]",
             "30000 characters"},
        Case{"bigGain",
             robot("<plugin name=\"p\" filename=\"odemt-fourier-gait\"><gain>1e300</gain></plugin>"),
             m + "/plugin[p]/gain", "'1e300' is not between"},
        Case{
            "doubledGain",
            robot("<plugin name=\"p\" filename=\"odemt-fourier-gait\"><gain>1</gain><gain>2</gain></plugin>"),
            m + "/plugin[p]/gain", "is written twice"},
        Case{"ourAttribute", worldWith("<physics type=\"ode\"><odemt:damping unit=\"1\"/></physics>", ""),
             "/sdf/world/physics/odemt:damping", "has no attribute 'unit'"}),
    [](const auto &info) { return info.param.name; });

// What is left aside cannot fail, whatever is inside.
TEST(Message, IsNoneForWhatIsLeftAside) {
    EXPECT_NO_THROW(
        load(robot("<link name=\"c\"><visual name=\"v\"><transparency>x</transparency></visual>"
                   "<sensor name=\"s\" type=\"odd\"><update_rate>q</update_rate></sensor></link>")));
}

}  // namespace
