#include "loader/load_world.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "loader/description/repeat_obstacles.h"
#include "loader/load_error.h"
#include "loader/read/document.h"
#include "loader/read/read_world.h"
#include "loader/read/regular_file.h"
#include "support/text.h"

namespace fs = std::filesystem;

namespace worlds {

namespace {

std::unique_ptr<SdfScene> build(const std::string &sdf, const std::string &name, const LoadOptions &options) {
    const Issues issues(options);
    const ResourceFinder resources(name, options.modelFolders);
    const Reading reading{resources, issues};
    WorldDescription world = readWorld(readDocument(sdf, name, reading), reading);
    world.staticMeetsStatic = options.staticMeetsStatic;
    if (options.staticShapes > 0) repeatObstacles(world, options.staticShapes, {name, "/sdf/world"});
    return std::make_unique<SdfScene>(world);
}

}  // namespace

std::unique_ptr<SdfScene> loadWorld(const std::string &file, const LoadOptions &options) {
    return loadWorldText(readTextFile(file), file, options);
}

std::unique_ptr<SdfScene> loadWorldText(const std::string &sdf, const std::string &name,
                                        const LoadOptions &options) {
    return withMemoryFor({name, "/sdf/world"}, [&] { return build(sdf, name, options); });
}

namespace {

// Of the tree that this program is installed in, else of the sources.
std::string ownFolder() {
    std::error_code none;  // a path that cannot be examined does not exist
    const fs::path installed = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / "share/ode_mt/worlds";
    return fs::is_directory(installed, none) ? installed.string() : ODE_MT_WORLDS_SOURCE_DIR;
}

}  // namespace

std::string worldFolder() {
    if (const char *chosen = secure_getenv("ODE_MT_WORLDS"); chosen && *chosen) return chosen;
    return ownFolder();
}

std::string commonModelFolder() { return ownFolder() + "/models"; }

std::vector<std::string> availableWorlds() {
    std::vector<std::string> names;
    std::error_code none;  // a folder that is missing holds no worlds
    for (const fs::directory_entry &entry : fs::directory_iterator(worldFolder(), none))
        if (entry.path().extension() == ".sdf") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::string worldsInFolder() {
    const std::string folder = worldFolder(), name = support::printable(folder);
    std::error_code none;
    if (!fs::is_directory(folder, none)) return name + " is not a folder";
    const std::vector<std::string> worlds = availableWorlds();
    if (worlds.empty()) return name + " holds no world";
    std::string text = name + " holds";
    for (const std::string &world : worlds) text += ' ' + support::printable(world);
    return text;
}

namespace {

// Whether there is anything by that name; `isFile` says whether it is a file.
bool isThere(const fs::path &path, bool &isFile) {
    std::error_code none;  // a path that cannot be followed may be there nevertheless
    isFile = fs::is_regular_file(path, none);
    return fs::exists(fs::symlink_status(path, none));
}

}  // namespace

std::string findWorld(const std::string &nameOrFile) {
    bool isFile = false;
    const bool isNamed = isThere(nameOrFile, isFile);
    if (isFile) return nameOrFile;
    const fs::path inFolder = fs::path(worldFolder()) / (nameOrFile + ".sdf");
    if (isThere(inFolder, isFile)) return inFolder;
    if (isNamed) throw std::invalid_argument(nameOrFile + ": " + whyNotReadable(nameOrFile, longestTextFile));

    throw std::invalid_argument("no world " + support::quote(support::printable(nameOrFile)) + ": no such file, and " + worldsInFolder());
}

}  // namespace worlds
