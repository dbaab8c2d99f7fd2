#include "scenes/scene.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

std::string complaint(const std::string &description) {
    try {
        scenes::checkScene(description);
    } catch (const std::invalid_argument &error) {
        return error.what();
    }
    return "";
}

void expectComplaint(const std::string &description, const std::vector<std::string> &words) {
    const std::string text = complaint(description);
    for (const std::string &word : words)
        EXPECT_NE(text.find(word), std::string::npos) << description << ": '" << text << "' lacks " << word;
}

}  // namespace

TEST(Catalogue, KnowsEverySceneOfTheList) {
    for (const scenes::SceneDescription &scene : scenes::availableScenes()) {
        EXPECT_EQ(complaint(scene.name), "");
        EXPECT_EQ(complaint(scene.name + ":3"), "");
        for (const scenes::SceneDescription &modifier : scenes::availableModifiers())
            EXPECT_EQ(complaint(scene.name + ":3," + modifier.name), "");
    }
}

TEST(Catalogue, NamesWhatIsWrongAndWhatExists) {
    expectComplaint("moon", {"'moon'", "rover", "vehicles_heightfield"});
    expectComplaint("", {"''", "rover"});
    expectComplaint("stacks,fast", {"'fast'", "quick", "autodisable"});
    expectComplaint("stacks:2,", {"''", "quick"});
    expectComplaint("stacks:2,sap,,quick", {"''"});
}

TEST(Catalogue, RefusesAbsurdSizes) {
    for (const char *size : {"0", "-1", "", "2x", "1.5", "100000000000", "0x10", " 3"})
        expectComplaint(std::string("stacks:") + size, {"'" + std::string(size) + "'", "stacks", "100000"});
}

TEST(Catalogue, MakeSceneThrowsAsCheckSceneDoes) {
    EXPECT_THROW(scenes::makeScene("moon"), std::invalid_argument);
    EXPECT_THROW(scenes::makeScene("stacks:0"), std::invalid_argument);
}
