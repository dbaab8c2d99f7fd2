// Finds the files and folders that a world names by URI.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace worlds {

// Variables that name folders of models, parted by ':'. Those of Gazebo's releases, and libsdformat's.
constexpr std::array<const char *, 4> kModelFolderVariables = {"SDF_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH",
                                                               "GAZEBO_MODEL_PATH"};

class ResourceFinder {
public:
    // `worldFile` may be a name of a text in memory; its folder is then the current one.
    ResourceFinder(const std::string &worldFile, const std::vector<std::string> &modelFolders);

    // model://m/mesh.stl, file:///a/b, /a/b, a name relative to the folder of `namedIn`, or the URL of a model, which is
    // searched among those that Gazebo has fetched before. Empty when there is nothing by that name.
    std::string find(const std::string &uri, const std::string &namedIn) const;

    // For messages: "looked for in /a and /b; SDF_PATH, … name further folders".
    std::string whereSearched(const std::string &uri, const std::string &namedIn) const;

private:
    std::vector<std::string> m_folders;  // tried in order
};

}  // namespace worlds
