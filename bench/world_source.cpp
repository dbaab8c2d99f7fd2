#include "world_source.h"

#include "support/text.h"
#include "loader/world_folder.h"
#include "size_range.h"
#include "world_spec.h"

#include <algorithm>
#include <stdexcept>

namespace bench {

namespace {

// Those of the thesis's chapter 3, then those of its table 2.1.
const std::vector<std::string> kWorldsOfTheThesis = {"pioneer3at", "bioloid", "create",   "soccer",
                                                     "epuck",      "epucks",  "humanoid", "humanoids"};

bool isModifier(const std::string &word) {
    if (word == kStaticMeetsStatic) return true;
    const auto modifiers = scenes::availableModifiers();
    return std::any_of(modifiers.begin(), modifiers.end(),
                       [&](const scenes::SceneDescription &modifier) { return modifier.name == word; });
}

std::string nameAndMeaning(const scenes::SceneDescription &description) {
    std::string name = "  " + description.name;
    name.resize(std::max<std::size_t>(name.size() + 1, 24), ' ');
    return name + description.meaning + "\n";
}

// A modifier belongs to the world before it.
std::vector<std::string> splitWords(const std::string &list) {
    std::vector<std::string> result;
    bool isOfTheThesis = false;  // the word before
    for (const std::string &word : support::splitAtCommas(list)) {
        if (isModifier(word) && isOfTheThesis)
            throw std::invalid_argument("'thesis," + word + "': a modifier belongs to one world");
        isOfTheThesis = word == "thesis";
        if (!result.empty() && isModifier(word))
            result.back() += "," + word;
        else if (isOfTheThesis)
            result.insert(result.end(), kWorldsOfTheThesis.begin(), kWorldsOfTheThesis.end());
        else
            result.push_back(word);
    }
    return result;
}

}  // namespace

std::vector<std::string> splitWorlds(const std::string &list) {
    std::vector<std::string> result;
    for (const std::string &world : splitWords(list)) {
        const std::vector<std::string> ofEachSize = expandSizes(world);
        result.insert(result.end(), ofEachSize.begin(), ofEachSize.end());
    }
    return result;
}

void checkWorld(const std::string &world) {
    const WorldSpec spec = readWorldSpec(world);
    if (spec.isSdf) {
        worlds::findWorld(spec.name);
        loadOptions(spec);
        return;
    }
    const auto scenes = scenes::availableScenes();
    if (std::none_of(scenes.begin(), scenes.end(),
                     [&](const auto &scene) { return scene.name == spec.name; })) {
        std::vector<std::string> names;
        for (const scenes::SceneDescription &scene : scenes) names.push_back(scene.name);
        throw std::invalid_argument(
            "unknown world '" + world + "'; SDF worlds: " + worlds::worldsInFolder() +
            ", or the path of an .sdf file; scenes: " + support::join(names) + " (:N for their size)");
    }
    scenes::checkScene(world);
}

std::unique_ptr<scenes::Scene> openWorld(const std::string &world, const Unsupported &unsupported,
                                         std::vector<std::string> &warnings) {
    checkWorld(world);
    const WorldSpec spec = readWorldSpec(world);
    if (!spec.isSdf) return scenes::makeScene(world);
    worlds::LoadOptions options = loadOptions(spec);
    options.ignoreUnsupported = unsupported.isLeftOut;
    options.ignoringOption = unsupported.option;
    options.warnings = &warnings;
    return worlds::loadWorld(worlds::findWorld(spec.name), options);
}

std::string listWorlds() {
    std::string text = "SDF worlds in " + worlds::worldFolder() + " (or the path of any .sdf file):\n";
    const std::vector<std::string> inFolder = worlds::availableWorlds();
    if (inFolder.empty()) text += "  none: " + worlds::worldsInFolder() + "\n";
    for (const std::string &world : inFolder) text += "  " + world + "\n";
    text += nameAndMeaning({"thesis", support::join(kWorldsOfTheThesis)});
    text += "\nWith N static shapes, as NAME:N. Modifier of an SDF world, as NAME,MODIFIER:\n";
    text +=
        nameAndMeaning({kStaticMeetsStatic, "ODE reports pairs of static shapes, which then are dropped"});
    text += "\nScenes, as NAME:N (or NAME:FIRST..LAST for sizes that double):\n";
    for (const scenes::SceneDescription &scene : scenes::availableScenes()) text += nameAndMeaning(scene);
    text += "\nModifiers of a scene, as NAME:N,MODIFIER:\n";
    for (const scenes::SceneDescription &modifier : scenes::availableModifiers())
        text += nameAndMeaning(modifier);
    return text;
}

}  // namespace bench
