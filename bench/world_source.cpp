#include "world_source.h"

#include "loader/load_world.h"
#include "loader/world_folder.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace bench {

namespace {

bool isModifier(const std::string &word) {
    const auto modifiers = scenes::availableModifiers();
    return std::any_of(modifiers.begin(), modifiers.end(),
                       [&](const scenes::SceneDescription &modifier) { return modifier.name == word; });
}

bool isSceneName(const std::string &word) {
    const auto all = scenes::availableScenes();
    return std::any_of(all.begin(), all.end(),
                       [&](const scenes::SceneDescription &scene) { return scene.name == word; });
}

bool isSdfWorld(const std::string &world) {
    const auto all = worlds::availableWorlds();
    const bool isFile = world.find('/') != std::string::npos || world.find(".sdf") != std::string::npos ||
                        world.find(".world") != std::string::npos;
    return isFile || std::find(all.begin(), all.end(), world) != all.end();
}

std::string join(const std::vector<std::string> &words) {
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string nameAndMeaning(const scenes::SceneDescription &description) {
    std::string name = "  " + description.name;
    name.resize(std::max<std::size_t>(name.size() + 1, 24), ' ');
    return name + description.meaning + "\n";
}

}  // namespace

std::vector<std::string> splitWorlds(const std::string &list) {
    std::vector<std::string> result;
    std::istringstream stream(list);
    for (std::string word; std::getline(stream, word, ',');) {
        if (!result.empty() && isModifier(word))
            result.back() += "," + word;
        else
            result.push_back(word);
    }
    return result;
}

void checkWorld(const std::string &world) {
    if (isSdfWorld(world)) {
        worlds::findWorld(world);
        return;
    }
    const std::string name = world.substr(0, world.find_first_of(":,"));
    if (!isSceneName(name)) {
        std::vector<std::string> names;
        for (const scenes::SceneDescription &scene : scenes::availableScenes()) names.push_back(scene.name);
        throw std::invalid_argument(
            "unknown world '" + world + "'; SDF worlds: " + join(worlds::availableWorlds()) +
            " or the path of an .sdf file; scenes: " + join(names) + " (:N for their size)");
    }
    scenes::checkScene(world);
}

std::unique_ptr<scenes::Scene> openWorld(const std::string &world, bool ignoreUnsupported,
                                         std::vector<std::string> &warnings) {
    checkWorld(world);
    if (!isSdfWorld(world)) return scenes::makeScene(world);
    worlds::LoadOptions options;
    options.ignoreUnsupported = ignoreUnsupported;
    options.warnings = &warnings;
    return worlds::loadWorld(worlds::findWorld(world), options);
}

std::string listWorlds() {
    std::string text = "SDF worlds in " + worlds::worldFolder() + " (or the path of any .sdf file):\n";
    for (const std::string &world : worlds::availableWorlds()) text += "  " + world + "\n";
    text += "\nScenes, as NAME:N:\n";
    for (const scenes::SceneDescription &scene : scenes::availableScenes()) text += nameAndMeaning(scene);
    text += "\nModifiers of a scene, as NAME:N,MODIFIER:\n";
    for (const scenes::SceneDescription &modifier : scenes::availableModifiers())
        text += nameAndMeaning(modifier);
    return text;
}

}  // namespace bench
