#include "loader/read/resource_finder.h"

#include "loader/load_error.h"
#include "loader/read/value_check.h"
#include "loader/load_world.h"
#include "support/text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace fs = std::filesystem;

namespace worlds {

namespace {

constexpr std::size_t kMaxFoldersShown = 8;

std::vector<std::string> foldersOf(const char *variable) {
    std::vector<std::string> folders;
    if (const char *list = std::getenv(variable)) {
        for (const std::string &folder : support::split(list, ':'))
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

bool startsWith(const std::string &text, const std::string &begin) { return text.compare(0, begin.size(), begin) == 0; }

// Cuts `scheme` off the front of the URI, if it is there.
bool cut(std::string &uri, const std::string &scheme) {
    if (!startsWith(uri, scheme)) return false;
    uri.erase(0, scheme.size());
    return true;
}

bool isUrl(const std::string &uri) { return startsWith(uri, "http://") || startsWith(uri, "https://"); }

bool isNumber(const std::string &text) {
    return !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
}

// "My%20Model" as Gazebo names its folder: "my model".
std::string folderName(const std::string &part) {
    std::string name;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const bool isSpace = part.compare(i, 3, "%20") == 0;
        name += isSpace ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(part[i])));
        if (isSpace) i += 2;
    }
    return name;
}

// A model of Gazebo Fuel: https://HOST/1.0/OWNER/models/NAME/VERSION/files/FILE, of which the last three parts and "1.0"
// may be missing.
struct FuelModel {
    std::string owner, name, version, file;
};

std::optional<FuelModel> fuelModel(const std::string &url) {
    std::vector<std::string> parts;
    for (const std::string &part : support::split(url.substr(url.find("://") + 3), '/')) {
        if (part == "." || part == "..") return std::nullopt;
        if (!part.empty()) parts.push_back(part);
    }
    if (parts.size() > 1 && parts[1] == "1.0") parts.erase(parts.begin() + 1);
    if (parts.size() < 4 || parts[2] != "models") return std::nullopt;
    FuelModel model{folderName(parts[1]), folderName(parts[3]), {}, {}};
    std::size_t next = 4;
    if (next < parts.size() && (isNumber(parts[next]) || parts[next] == "tip")) model.version = parts[next++];
    if (next < parts.size() && parts[next] == "files") ++next;
    for (; next < parts.size(); ++next) model.file += "/" + parts[next];
    return model;
}

// Where Gazebo keeps what it has fetched: the releases' own folders.
std::vector<std::string> fuelFolders() {
    std::vector<std::string> folders;
    const char *const home = std::getenv("HOME");
    for (const auto &[variable, folder] : {std::pair("GZ_FUEL_CACHE_PATH", "/.gz/fuel"), std::pair("IGN_FUEL_CACHE_PATH", "/.ignition/fuel")}) {
        if (const char *const chosen = std::getenv(variable); chosen && *chosen)
            folders.push_back(chosen);
        else if (home && *home)
            folders.push_back(std::string(home) + folder);
    }
    return folders;
}

// The folder of the newest version in a model's folder; empty when there is none.
std::string newestVersion(const fs::path &model) {
    long newest = -1;
    std::error_code none;  // a folder that is missing holds nothing
    for (const fs::directory_entry &entry : fs::directory_iterator(model, none))
        if (const std::string name = entry.path().filename(); isNumber(name)) newest = std::max(newest, std::stol(name));
    return newest < 0 ? std::string() : (model / std::to_string(newest)).string();
}

// Two models that nearly every world has, by URL or as model://, are among ours.
std::string ownModel(const FuelModel &model) {
    if (model.owner != "openrobotics" || !model.file.empty()) return {};
    if (model.name == "sun") return commonModelFolder() + "/sun";
    return model.name == "ground plane" ? commonModelFolder() + "/ground_plane" : std::string();
}

// The server had another name before, by which older releases keep its models.
std::string findFetched(const std::string &url) {
    const std::optional<FuelModel> model = fuelModel(url);
    if (!model) return {};
    for (const fs::path folder : fuelFolders())
        for (const char *const host : {"fuel.gazebosim.org", "fuel.ignitionrobotics.org"}) {
            const fs::path versions = folder / host / model->owner / "models" / model->name;
            const std::string version =
                isNumber(model->version) ? (versions / model->version).string() : newestVersion(versions);
            if (!version.empty() && isThere(version + model->file)) return version + model->file;
        }
    return ownModel(*model);
}

std::string listed(const std::vector<std::string> &folders) {
    std::string text;
    for (std::size_t i = 0; i < std::min(folders.size(), kMaxFoldersShown); ++i)
        text += (i ? ", " : "") + (folders[i].empty() ? "the current folder" : support::shortened(folders[i]));
    if (folders.size() > kMaxFoldersShown) text += " and " + std::to_string(folders.size() - kMaxFoldersShown) + " more";
    return text;
}

}  // namespace

ResourceFinder::ResourceFinder(const std::string &worldFile, const std::vector<std::string> &modelFolders) {
    const fs::path folder = fs::path(worldFile).parent_path();
    append(m_folders, modelFolders);
    append(m_folders, {folder / "models", folder});
    for (const char *const variable : kModelFolderVariables) append(m_folders, foldersOf(variable));
    m_folders.push_back(commonModelFolder());
}

std::string ResourceFinder::find(const std::string &uri, const std::string &namedIn) const {
    std::string name = uri;
    if (name.empty()) return {};
    if (isUrl(uri)) return findFetched(uri);
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

std::string ResourceFinder::whereSearched(const std::string &uri, const std::string &namedIn) const {
    if (isUrl(uri)) return "nothing is fetched, and among what Gazebo has fetched, in " + listed(fuelFolders()) + ", it is not";
    std::string name = uri;
    std::vector<std::string> folders = m_folders;
    if (!cut(name, "model://") && !cut(name, "package://")) {
        cut(name, "file://");
        if (fs::path(name).is_absolute()) return "there is no such file";
        folders.insert(folders.begin(), fs::path(namedIn).parent_path());
    }
    std::vector<std::string> distinct;  // in order
    for (const std::string &folder : folders)
        if (std::find(distinct.begin(), distinct.end(), folder) == distinct.end()) distinct.push_back(folder);
    return "looked for in " + listed(distinct) + "; " +
           support::join({kModelFolderVariables.begin(), kModelFolderVariables.end()}, ", ") + " name further folders";
}

}  // namespace worlds
