#include "loader/world_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;

namespace worlds {

std::string worldFolder() {
    if (const char *chosen = secure_getenv("ODE_MT_WORLDS"); chosen && *chosen) return chosen;
    if (fs::is_directory(ODE_MT_WORLDS_SOURCE_DIR)) return ODE_MT_WORLDS_SOURCE_DIR;
    return ODE_MT_WORLDS_INSTALL_DIR;
}

std::vector<std::string> availableWorlds() {
    std::vector<std::string> names;
    std::error_code none;  // a folder that is missing holds no worlds
    for (const fs::directory_entry &entry : fs::directory_iterator(worldFolder(), none))
        if (entry.path().extension() == ".sdf") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::string findWorld(const std::string &nameOrFile) {
    if (fs::is_regular_file(nameOrFile)) return nameOrFile;
    const fs::path inFolder = fs::path(worldFolder()) / (nameOrFile + ".sdf");
    if (fs::is_regular_file(inFolder)) return inFolder;

    std::string message = "no world '" + nameOrFile + "': no such file, and " + worldFolder() + " holds";
    for (const std::string &name : availableWorlds()) message += ' ' + name;
    throw std::invalid_argument(message);
}

}  // namespace worlds
