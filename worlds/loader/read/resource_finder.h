// Finds the files and folders that a world names by URI.
#pragma once

#include <string>
#include <vector>

namespace worlds {

class ResourceFinder {
public:
    // `worldFile` may be a name of a text in memory; its folder is then the current one.
    ResourceFinder(const std::string &worldFile, const std::vector<std::string> &modelFolders);

    // model://m/mesh.stl, file:///a/b, /a/b or a name relative to the folder of `namedIn`. Empty when
    // there is nothing by that name.
    std::string find(const std::string &uri, const std::string &namedIn) const;

private:
    std::vector<std::string> m_folders;  // tried in order
};

}  // namespace worlds
