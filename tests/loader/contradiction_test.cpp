// What is said twice, or against something else, is an error.
#include "small_world.h"

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

std::string robot(const std::string &plugins) {
    return world("<model name=\"m\">" + linkOf1kg("a", "0 0 0 0 0 0") + linkOf1kg("b", "1 0 0 0 0 0") +
                 "<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 "
                 "1</xyz></axis></joint>" +
                 plugins + "</model>");
}
std::string schedule(const std::string &name, const std::string &joints, const std::string &speeds) {
    return "<plugin name=\"" + name + "\" filename=\"odemt-velocity-schedule\"><joints>" + joints +
           "</joints><phase duration=\"1\">" + speeds + "</phase></plugin>";
}

TEST(Contradiction, AJointHasOneController) {
    EXPECT_NO_THROW(load(robot(schedule("p", "j", "1"))));
    expectError(robot(schedule("p", "j j", "1 2")), Kind::Value,
                {"/plugin[p]/joints", "joint 'j' is driven already"});
    expectError(robot(schedule("p", "j", "1") + schedule("q", "j", "2")), Kind::Value,
                {"/plugin[q]/joints", "joint 'j' is driven already"});
    expectError(robot("<plugin name=\"p\" filename=\"odemt-fourier-gait\"><gain>1</gain><hold "
                      "joint=\"j\">0</hold><hold joint=\"j\">1</hold></plugin>"),
                Kind::Value, {"/plugin[p]/hold", "joint 'j' is driven already"});
}

TEST(Contradiction, FramesAndModelsOfAWorldShareTheirNames) {
    const std::string model = "<model name=\"m\"><link name=\"l\"/></model>", frame = "<frame name=\"m\"/>";
    expectError(world(model + frame), Kind::Value, {"/sdf/world/frame[m]: a <model> is called 'm', too"});
    expectError(world(frame + model), Kind::Value, {"/sdf/world/model[m]: a <frame> is called 'm', too"});
    expectError(world(frame + frame), Kind::Value, {"/sdf/world/frame[m]: a second <frame> is called 'm'"});
}

TEST(Contradiction, OnePhysicsIsTheDefault) {
    const std::string first = "<physics name=\"p\" default=\"true\" type=\"ode\"/>",
                      second = "<physics name=\"q\" default=\"1\" type=\"ode\"/>";
    EXPECT_NO_THROW(load(worldWith(first, "")));
    expectError(worldWith(first + second, ""), Kind::Value, {"/sdf/world/physics: is a second default"});
}

TEST(Contradiction, ANumberHasOneSign) {
    for (const char *const pose : {"0 +-1 0 0 0 0", "+ 1 0 0 0 0", "0 -+1 0 0 0 0"})
        expectError(
            world("<model name=\"m\"><pose>" + std::string(pose) + "</pose><link name=\"l\"/></model>"),
            Kind::Value, {"/sdf/world/model[m]/pose", "is not a number"});
}

}  // namespace
