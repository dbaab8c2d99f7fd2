#include "text_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace bench {

std::string readTextFile(const std::string &file) {
    struct stat status {};
    if (stat(file.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) throw std::runtime_error(file + ": is a folder");
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream || stream.bad()) throw std::runtime_error(file + ": " + (errno != 0 ? std::strerror(errno) : "cannot be read"));
    return text;
}

}  // namespace bench
