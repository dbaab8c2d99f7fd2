// The same world in other letters is the same world.
#include "small_world.h"

namespace {

using namespace small_world;

std::string hinged(const std::string &pose, const std::string &speeds) {
    return world(
        "<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", pose) +
        "<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 "
        "1</xyz></axis></joint>"
        "<joint name=\"k\" type=\"prismatic\"><parent>a</parent><child>b</child><axis><xyz>0 0 "
        "1</xyz></axis></joint>"
        "<plugin name=\"p\" filename=\"odemt-velocity-schedule\"><joints>j k</joints><phase duration=\"1\">" +
        speeds + "</phase></plugin></model>");
}

TEST(Spelling, CommentsMayStandWithinAValue) {
    const auto plain = load(hinged("1 2 3 0 0 0.5", "0.5 0.25"));
    const auto spelled =
        load(hinged("<!-- m -->1 2 3 <!-- rad --> 0 0<!-- yaw --> 0.5", "0.5 <!-- m/s -->0.25"));
    EXPECT_EQ(position(body(*spelled, "m::b")), position(body(*plain, "m::b")));
    run(*plain, 3);
    run(*spelled, 3);
    EXPECT_EQ(position(body(*spelled, "m::b")), position(body(*plain, "m::b")));
    EXPECT_EQ(spin(body(*spelled, "m::b")), spin(body(*plain, "m::b")));
}

TEST(Spelling, CommentsPartNumbers) {
    expectError(hinged("1 2 3 0 0 0<!-- -->5", "0 0"), worlds::LoadError::Kind::Value,
                {"/link[b]/pose", "has 7 numbers"});
}

}  // namespace
