#include "support/text_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace support {

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

void writeTextFile(const std::string &file, const std::string &text) {
    if (const std::filesystem::path folder = std::filesystem::path(file).parent_path(); !folder.empty())
        std::filesystem::create_directories(folder);
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << text << std::flush)) throw std::runtime_error(file + ": cannot be written");
}

bool writeAll(int file, const std::string &text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = write(file, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

}  // namespace support
