#include "text_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace bench {

std::string readTextFile(const std::string &file) {
    struct stat status {};
    if (stat(file.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) throw std::runtime_error(file + ": is a folder");
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    try {
        if (stream) return {std::istreambuf_iterator<char>(stream), {}};
    } catch (const std::ios_base::failure &) {  // of the buffer, which iterators read: the stream does not notice
    }
    throw std::runtime_error(file + ": " + (errno != 0 ? std::strerror(errno) : "cannot be read"));
}

std::string readWhatIsThere(const std::string &file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace bench
