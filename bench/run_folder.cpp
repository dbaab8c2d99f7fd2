#include "run_folder.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace bench {

namespace {

std::string temporaryFolder() {
    const std::string folder = std::filesystem::temp_directory_path();
    return folder.find_first_of(" :;$") == std::string::npos ? folder : "/tmp";
}

}  // namespace

RunFolder::RunFolder(const std::string &nameOfTool) {
    m_path = temporaryFolder() + '/' + nameOfTool + "_XXXXXX";
    if (mkdtemp(m_path.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + m_path);
}

RunFolder::~RunFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

std::string RunFolder::addLibrary(const std::string &folder, const std::string &library) const {
    const std::filesystem::path made = std::filesystem::path(m_path) / folder;
    std::filesystem::create_directory(made);
    std::filesystem::create_symlink(std::filesystem::canonical(library), made / "libode.so.8");
    return made;
}

std::string inFront(const std::string &path, const char *variable) {
    const char *const others = std::getenv(variable);
    return others != nullptr && *others != '\0' ? path + ':' + others : path;
}

}  // namespace bench
