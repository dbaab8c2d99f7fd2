#include "library_folders.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "support/text.h"

namespace bench {

std::string folderOfThisProgram() { return std::filesystem::read_symlink("/proc/self/exe").parent_path(); }

std::string folderOfStockLibrary() { return ODEMT_STOCK_FOLDER; }

std::string commandsForStockLibrary() {
    return "apt-get download " ODE_MT_DEBIAN_PACKAGE " && dpkg-deb -x " ODE_MT_DEBIAN_PACKAGE "_*.deb stock";
}

std::string folderOfOurLibrary() {
    const std::filesystem::path above = std::filesystem::path(folderOfThisProgram()).parent_path();
    for (const std::filesystem::path &folder : {above / "lib", above / ODEMT_SYSTEM_LIBRARIES})
        if (std::filesystem::exists(folder / "libode.so.8")) return folder;
    return ODEMT_OUR_FOLDER;
}

std::string libraryAt(const std::string &path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored) ? (std::filesystem::path(path) / "libode.so.8").string() : path;
}

void checkLibraryFolder(const std::string &option, const std::string &folder) {
    if (!std::filesystem::exists(std::filesystem::path(folder) / "libode.so.8"))
        throw std::invalid_argument(option + ": no libode.so.8 in '" + folder + "'");
}

std::vector<std::string> preloadedLibraries() {
    const char *const text = std::getenv("LD_PRELOAD");
    std::string names = text != nullptr ? text : "";
    std::replace(names.begin(), names.end(), ':', ' ');
    return support::splitAtBlanks(names);
}

std::string addLibrary(const support::TemporaryFolder &in, const std::string &folder, const std::string &library) {
    const std::filesystem::path made = in.path() / folder;
    std::filesystem::create_directory(made);
    std::filesystem::create_symlink(std::filesystem::canonical(library), made / "libode.so.8");
    return made;
}

std::string inFront(const std::string &path, const char *variable) {
    const char *const others = std::getenv(variable);
    return others != nullptr && *others != '\0' ? path + ':' + others : path;
}

std::vector<std::string> libraryVariables() {
    const std::string prefix = "ODE_MT_";
    std::vector<std::string> names;
    for (char **entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        if (name.compare(0, prefix.size(), prefix) == 0 && name != "ODE_MT_WORLDS") names.push_back(name);
    }
    return names;
}

}  // namespace bench
