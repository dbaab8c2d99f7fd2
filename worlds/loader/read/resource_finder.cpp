#include "loader/read/resource_finder.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace fs = std::filesystem;

namespace worlds {

namespace {

std::vector<std::string> foldersOf(const char *variable) {
    std::vector<std::string> folders;
    if (const char *list = std::getenv(variable)) {
        std::istringstream stream(list);
        for (std::string folder; std::getline(stream, folder, ':');)
            if (!folder.empty()) folders.push_back(folder);
    }
    return folders;
}

void append(std::vector<std::string> &list, const std::vector<std::string> &more) {
    list.insert(list.end(), more.begin(), more.end());
}

bool isThere(const fs::path &path) {
    std::error_code none;  // a path that cannot be examined does not exist
    return fs::exists(path, none);
}

// Cuts `scheme` off the front of the URI, if it is there.
bool cut(std::string &uri, const std::string &scheme) {
    if (uri.compare(0, scheme.size(), scheme) != 0) return false;
    uri.erase(0, scheme.size());
    return true;
}

}  // namespace

ResourceFinder::ResourceFinder(const std::string &worldFile, const std::vector<std::string> &modelFolders) {
    const fs::path folder = fs::path(worldFile).parent_path();
    append(m_folders, modelFolders);
    append(m_folders, {folder / "models", folder});
    append(m_folders, foldersOf("SDF_PATH"));
    append(m_folders, foldersOf("GZ_SIM_RESOURCE_PATH"));
}

std::string ResourceFinder::find(const std::string &uri, const std::string &namedIn) const {
    std::string name = uri;
    if (name.empty()) return {};
    const bool inModelFolder = cut(name, "model://") || cut(name, "package://");
    if (!inModelFolder) {
        cut(name, "file://");
        const fs::path besideFile = fs::path(namedIn).parent_path() / name;  // `name` itself if absolute
        if (isThere(besideFile)) return besideFile;
        if (fs::path(name).is_absolute()) return {};
    }
    for (const fs::path folder : m_folders)
        if (isThere(folder / name)) return folder / name;
    return {};
}

}  // namespace worlds
