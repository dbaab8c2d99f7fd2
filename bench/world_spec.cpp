#include "world_spec.h"

#include "support/text.h"
#include "loader/world_folder.h"
#include "scenes/scene.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace bench {

const char *const kStaticMeetsStatic = "static_meets_static";

namespace {

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

}  // namespace bench
