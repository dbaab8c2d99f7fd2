#include "world_source.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "loader/load_world.h"
#include "scenes/scene.h"
#include "support/text.h"

namespace bench {

namespace {

// Twice as much as any size that a world takes, so that doubling does not overflow.
constexpr long kLargest = 1'000'000'000;

std::optional<long> readNumber(const std::string &text) {
    long number = 0;
    const char *end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stopped != end || number < 1 || number > kLargest) return std::nullopt;
    return number;
}

}  // namespace

std::vector<std::string> expandSizes(const std::string &world) {
    const std::size_t comma = world.find(','), colon = world.substr(0, comma).rfind(':');
    if (colon == std::string::npos) return {world};
    const std::string name = world.substr(0, colon + 1),
                      modifiers = comma < world.size() ? world.substr(comma) : "",
                      size = world.substr(colon + 1, comma < world.size() ? comma - colon - 1 : comma);
    const std::size_t dots = size.find("..");
    if (dots == std::string::npos) return {world};
    const std::optional<long> first = readNumber(size.substr(0, dots)),
                              last = readNumber(size.substr(dots + 2));
    if (!first || !last || *first > *last) return {world};
    std::vector<std::string> worlds;
    for (long n = *first; n <= *last; n *= 2) worlds.push_back(name + std::to_string(n) + modifiers);
    return worlds;
}

namespace {

const char *const kStaticMeetsStatic = "static_meets_static";  // a modifier of SDF worlds
constexpr std::size_t maxStaticShapes = 1'000'000;

bool isFile(const std::string &name) {
    return name.find('/') != std::string::npos || name.find(".sdf") != std::string::npos ||
           name.find(".world") != std::string::npos;
}

bool isSceneName(const std::string &name) {
    const auto all = scenes::availableScenes();
    return std::any_of(all.begin(), all.end(),
                       [&](const scenes::SceneDescription &scene) { return scene.name == name; });
}

// A name of both kinds is the scene once something is said that only scenes know.
bool isSdfWorld(const WorldSpec &spec) {
    if (isFile(spec.name)) return true;
    const auto all = worlds::availableWorlds();
    if (std::find(all.begin(), all.end(), spec.name) == all.end()) return false;
    const bool asScene = !spec.size.empty() || std::any_of(spec.modifiers.begin(), spec.modifiers.end(),
                                                           [](const std::string &modifier) {
                                                               return modifier != kStaticMeetsStatic;
                                                           });
    return !(asScene && isSceneName(spec.name));
}

std::size_t readStaticShapes(const WorldSpec &spec) {
    std::size_t count = 0;
    const char *end = spec.size.data() + spec.size.size();
    const auto [stopped, error] = std::from_chars(spec.size.data(), end, count);
    if (error != std::errc() || stopped != end || count < 1 || count > maxStaticShapes ||
        spec.size != std::to_string(count))
        throw std::invalid_argument("world '" + spec.name + "': size '" + spec.size +
                                    "' is not a number of static shapes from 1 to " +
                                    std::to_string(maxStaticShapes));
    return count;
}

}  // namespace

WorldSpec readWorldSpec(const std::string &world) {
    WorldSpec spec;
    spec.modifiers = support::splitAtCommas(world);
    if (!spec.modifiers.empty()) {
        spec.name = support::withoutEscapes(spec.modifiers.front());
        spec.modifiers.erase(spec.modifiers.begin());
    }
    const std::size_t colon = spec.name.rfind(':');
    if (colon != std::string::npos && !isFile(spec.name.substr(colon))) {
        spec.size = spec.name.substr(colon + 1);
        spec.name.resize(colon);
        if (spec.size.empty()) throw std::invalid_argument("world '" + world + "': no size behind the colon");
    }
    for (const std::string &modifier : spec.modifiers)
        if (std::count(spec.modifiers.begin(), spec.modifiers.end(), modifier) > 1)
            throw std::invalid_argument("world '" + world + "': '" + modifier + "' is said twice");
    spec.isSdf = isSdfWorld(spec);
    return spec;
}

worlds::LoadOptions loadOptions(const WorldSpec &spec) {
    worlds::LoadOptions options;
    if (!spec.size.empty()) options.staticShapes = readStaticShapes(spec);
    for (const std::string &modifier : spec.modifiers) {
        if (modifier != kStaticMeetsStatic)
            throw std::invalid_argument("world '" + spec.name + "': unknown modifier '" + modifier +
                                        "'; SDF worlds know " + kStaticMeetsStatic);
        options.staticMeetsStatic = true;
    }
    return options;
}

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
