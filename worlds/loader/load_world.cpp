#include "loader/load_world.h"

#include "loader/description/repeat_obstacles.h"
#include "loader/read/document.h"
#include "loader/read/read_world.h"
#include "loader/read/regular_file.h"

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

}  // namespace worlds
