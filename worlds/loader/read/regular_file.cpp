#include "loader/read/regular_file.h"

#include "loader/load_error.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace worlds {

std::string whyNotReadable(const std::string &file, std::uintmax_t maxBytes) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::strerror(errno);
    if (S_ISDIR(status.st_mode)) return "is a folder";
    if (!S_ISREG(status.st_mode)) return "is not a regular file";
    if (status.st_size == 0) return "is empty";
    if (static_cast<std::uintmax_t>(status.st_size) > maxBytes)
        return "has " + std::to_string(status.st_size) + " bytes, more than " + std::to_string(maxBytes);
    if (::access(file.c_str(), R_OK) != 0) return std::strerror(errno);
    return {};
}

bool readBytes(const std::string &file, std::string &bytes) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream read;
    if (!stream || !(read << stream.rdbuf())) return false;
    bytes = read.str();
    return true;
}

std::string readTextFile(const std::string &file) {
    const std::string wrong = whyNotReadable(file, longestTextFile);
    if (!wrong.empty()) throw LoadError(LoadError::Kind::File, {file, ""}, wrong);
    std::string text;
    if (!readBytes(file, text)) throw LoadError(LoadError::Kind::File, {file, ""}, std::strerror(errno));
    return text;
}

}  // namespace worlds
