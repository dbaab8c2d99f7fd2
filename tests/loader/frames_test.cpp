// Frames: what is relative or attached to what, in models within models and in merged ones, and what cannot
// be.
#include "small_world.h"
#include "test_folder.h"

#include <sys/resource.h>

namespace {

using namespace small_world;
using Kind = worlds::LoadError::Kind;

std::string frame(const std::string &name, const std::string &attributes, const std::string &pose = "") {
    return "<frame name=\"" + name + "\" " + attributes + ">" + pose + "</frame>";
}
std::string at(const std::string &frame, const std::string &numbers) {
    return "<pose relative_to=\"" + frame + "\">" + numbers + "</pose>";
}
std::string model(const std::string &name, const std::string &inside, const std::string &attributes = "") {
    return "<model name=\"" + name + "\" " + attributes + ">" + inside + "</model>";
}
std::string link(const std::string &name, const std::string &pose = "") {
    return "<link name=\"" + name + "\">" + pose + "</link>";
}

TEST(Frames, OrderDoesNotMatter) {
    const auto scene = load(world(model(
        "m", link("l", at("f", "1 0 0 0 0 0")) + frame("f", "attached_to=\"g\"", "<pose>0 1 0 0 0 0</pose>") +
                 frame("g", "", at("k", "0 0 1 0 0 0")) + link("k", "<pose>5 0 0 0 0 0</pose>"))));
    EXPECT_LT((position(body(*scene, "m::l")) - Vector3{6, 1, 1}).length(), 1e-12);
}

TEST(Frames, OfModelsWithinAreNamedByTheirPath) {
    const auto scene = load(world(model(
        "m", link("l", at("inner::deep::f", "1 0 0 0 0 0")) +
                 model("inner", "<pose>0 0 2 0 0 0</pose>" + link("k") +
                                    model("deep", "<pose>0 3 0 0 0 0</pose>" + link("d") +
                                                      frame("f", "", at("__model__", "7 0 0 0 0 0")))))));
    EXPECT_LT((position(body(*scene, "m::l")) - Vector3{8, 3, 2}).length(), 1e-12);
}

TEST(Frames, AJointMayNameAFrameOrAModel) {
    const auto scene = load(world(
        model("m", link("l") + frame("f", "attached_to=\"l\"") +
                       model("inner", link("a") + link("b"), "canonical_link=\"b\"") +
                       "<joint name=\"j\" type=\"fixed\"><parent>f</parent><child>inner</child></joint>")));
    EXPECT_EQ(dJointGetBody(joint(*scene, "m::j"), 0), body(*scene, "m::inner::b"));
    EXPECT_EQ(dJointGetBody(joint(*scene, "m::j"), 1), body(*scene, "m::l"));
}

TEST(Frames, AVeryLongChainIsFollowed) {
    std::string chain = link("l", at("f19999", "0 0 0 0 0 0"));
    for (int i = 19999; i > 0; --i)
        chain += frame("f" + std::to_string(i), "", at("f" + std::to_string(i - 1), "0.001 0 0 0 0 0"));
    const auto scene = load(
        world(model("m", chain + frame("f0", "attached_to=\"l\"", "<pose relative_to=\"__model__\"/>"))));
    EXPECT_NEAR(position(body(*scene, "m::l")).x, 19.999, 1e-9);
}

TEST(Frames, CirclesAreErrors) {
    const std::string m = "test.sdf: /sdf/world/model[m]";
    expectError(world(model("m", link("l") + frame("f", "attached_to=\"f\""))), Kind::Value,
                {m + "/frame[f]: ", "in a cycle"});
    expectError(
        world(model("m", link("l", at("f", "")) + frame("f", "", at("g", "")) + frame("g", "", at("f", "")))),
        Kind::Value, {m + "/frame[f]: is relative to itself, in a cycle"});
    expectError(world(frame("f", "attached_to=\"g\"") + frame("g", "attached_to=\"f\"")), Kind::Value,
                {"test.sdf: /sdf/world/frame[f]: ", "in a cycle"});
    expectError(world(model("m", link("l") + frame("f", ""), "canonical_link=\"f\"")), Kind::Value,
                {m + ": canonical_link: 'f' is no link"});
    expectError(world(model("m", link("l"), "canonical_link=\"__model__\"")), Kind::Value,
                {m + ": canonical_link: "});
}

TEST(Frames, WhatIsNotThereIsNamed) {
    const std::string m = "test.sdf: /sdf/world/model[m]";
    expectError(world(model("m", link("l"), "placement_frame=\"q\"")), Kind::Value,
                {m + ": placement_frame: no frame 'q' in the model 'm'"});
    expectError(world(model("m", link("l"), "canonical_link=\"q\"")), Kind::Value,
                {m + ": canonical_link: no frame 'q'"});
    expectError(world(model("m", link("l") + frame("f", "attached_to=\"q\""))), Kind::Value,
                {m + "/frame[f]: attached_to: no frame 'q' in the model 'm'"});
    expectError(world(model("m", link("l") + model("n", link("k")) + frame("f", "attached_to=\"n::q\""))),
                Kind::Value, {m + "/frame[f]: attached_to: no frame 'q' in the model 'n'"});
    expectError(world(model("m", "<link name=\"l\"><collision name=\"c\">" + at("q", "0 0 0 0 0 0") +
                                     "<geometry>" + sphere(1) + "</geometry></collision></link>")),
                Kind::Value, {m + "/link[l]/collision[c]/pose: relative_to: no frame 'q'"});
}

TEST(Frames, AMergedModelGivesItsPartsToTheOneAround) {
    const TestFolder folder("frames");
    folder.write("arm.sdf",
                 "<sdf version=\"1.9\">" +
                     model("arm", "<pose>9 9 9 0 0 0</pose>" + link("upper", "<pose>0 0 1 0 0 0</pose>") +
                                      link("lower", at("upper", "0 0 1 0 0 0")) +
                                      "<joint name=\"elbow\" type=\"ball\"><parent>upper</parent>"
                                      "<child>lower</child></joint>") +
                     "</sdf>");
    const auto loadWith = [&](const std::string &inside) {
        return worlds::loadWorldText(world(model("m", "<pose>1 0 0 0 0 0</pose>" + inside)),
                                     folder.path("test.sdf"));
    };
    const std::string include =
        "<include merge=\"true\"><uri>arm.sdf</uri><pose>0 2 0 0 0 0</pose></include>";
    const auto scene = loadWith(
        link("trunk") + include + link("hand", at("lower", "0 0 1 0 0 0")) +
        "<joint name=\"shoulder\" type=\"fixed\"><parent>trunk</parent><child>upper</child></joint>");
    EXPECT_LT((position(body(*scene, "m::lower")) - Vector3{1, 2, 2}).length(), 1e-12);
    EXPECT_LT((position(body(*scene, "m::hand")) - Vector3{1, 2, 3}).length(), 1e-12);
    EXPECT_EQ(dJointGetBody(joint(*scene, "m::shoulder"), 0), body(*scene, "m::upper"));
    EXPECT_NE(joint(*scene, "m::elbow"), nullptr);
    EXPECT_THROW(loadWith(link("lower") + include), worlds::LoadError);  // a second link of that name
}

// 3000 shapes take some 30 MB.
TEST(Frames, ManyModelsTakeLittleMemory) {
    std::string models;
    for (int i = 0; i < 3000; ++i)
        models +=
            staticModel("m" + std::to_string(i), "0 0 " + std::to_string(i) + " 0 0 0.1", box(1, 1, 0.5));
    EXPECT_EQ(load(world(models))->inventory().geoms.size(), 3000u);
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    EXPECT_LT(used.ru_maxrss, MOST_MEGABYTES << 10);  // kB
}

}  // namespace
