// An error names the element and the file that it is in, whatever others are called.
#include "small_world.h"
#include "test_folder.h"

namespace {

using namespace small_world;

const std::string two = "<link name=\"a\"/><link name=\"b\"/>";
std::string joint(const std::string &parent, const std::string &child) {
    return "<joint name=\"j\" type=\"fixed\"><parent>" + parent + "</parent><child>" + child +
           "</child></joint>";
}
std::string model(const std::string &name, const std::string &inside) {
    return "<model name=\"" + name + "\">" + inside + "</model>";
}
const std::string badInertia =
    "<link name=\"a\"><inertial><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>5</ixy></inertia></inertial></link>";

// The second of two models with the same names inside.
void expectSecond(const std::string &inside, const std::string &place) {
    const std::string good = model("good", two + joint("a", "b"));
    expectError(world(good + model("bad", inside)), worlds::LoadError::Kind::Value,
                {"test.sdf: /sdf/world/model[bad]" + place + ": "});
    expectError(world(model("outer", good + model("bad", inside))), worlds::LoadError::Kind::Value,
                {"test.sdf: /sdf/world/model[outer]/model[bad]" + place + ": "});
}

TEST(Blame, IsOnTheModelThatIsMeant) {
    expectSecond(badInertia, "/link[a]/inertial/inertia");
    expectSecond(two + joint("a", "a"), "/joint[j]");
    expectSecond(two + joint("a", "world"), "/joint[j]/child");
    expectSecond(two + joint("a", "q"), "/joint[j]/child");
    expectSecond("<link name=\"a\"/><link name=\"b\"><pose relative_to=\"b\"/></link>", "/link[b]");
}

TEST(Blame, IsOnTheJointThatReachesIntoAnotherModel) {
    expectError(world(model("good", two) + model("bad", two + joint("good::a", "b"))),
                worlds::LoadError::Kind::Value, {"test.sdf: /sdf/world/model[bad]/joint[j]/parent: "});
}

TEST(Blame, IsOnTheModelWhoseNamesAreNotUnique) {
    expectError(world(model("good", two) + model("bad", two + "<frame name=\"a\"/>")),
                worlds::LoadError::Kind::Value, {"test.sdf: /sdf/world/model[bad]/frame[a]: a <link> is called 'a', too"});
}

TEST(Blame, IsOnTheFrameThatIsMeant) {
    const std::string good = model("good", two + "<frame name=\"f\" attached_to=\"a\"/>");
    expectError(world(good + model("bad", two + "<frame name=\"f\" attached_to=\"f\"/>")),
                worlds::LoadError::Kind::Value, {"test.sdf: /sdf/world/model[bad]/frame[f]: "});
}

TEST(Blame, IsOnTheFileThatIsMeant) {
    const TestFolder folder("blame");
    const auto file = [&](const std::string &name, const std::string &inside) {
        folder.write(name + ".sdf", "<sdf version=\"1.9\">" + model("part", inside) + "</sdf>");
        return "<include><uri>" + name + ".sdf</uri><name>" + name + "</name></include>";
    };
    const std::string good = file("good", two + joint("a", "b"));
    const auto expectIn = [&](const std::string &name, const std::string &inside, const std::string &place) {
        try {
            worlds::loadWorldText(world(good + file(name, inside)), folder.path("test.sdf"));
            ADD_FAILURE() << "loaded";
        } catch (const worlds::LoadError &error) {
            EXPECT_EQ(
                std::string(error.what())
                    .find(folder.path(name + ".sdf") + ": /sdf/world/model[" + name + "]" + place + ": "),
                0u)
                << error.what();
        }
    };
    expectIn("heavy", badInertia, "/link[a]/inertial/inertia");
    expectIn("joined", two + joint("b", "b"), "/joint[j]");
    expectIn("lost", two + joint("a", "q"), "/joint[j]/child");
}

}  // namespace
