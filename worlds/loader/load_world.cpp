#include "loader/load_world.h"

#include "loader/read/document.h"
#include "loader/read/issues.h"
#include "loader/read/read_world.h"
#include "loader/read/resource_finder.h"

namespace worlds {

std::unique_ptr<SdfScene> loadWorld(const std::string &file, const LoadOptions &options) {
    return loadWorldText(readTextFile(file), file, options);
}

std::unique_ptr<SdfScene> loadWorldText(const std::string &sdf, const std::string &name,
                                        const LoadOptions &options) {
    const Issues issues(options);
    const ResourceFinder resources(name, options.modelFolders);
    const Document document(sdf, name, resources, issues);
    return std::make_unique<SdfScene>(readWorld(document.world(), name, resources, issues));
}

}  // namespace worlds
