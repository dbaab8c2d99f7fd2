#include "support/temporary_folder.h"

#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "support/text_file.h"

namespace support {

namespace fs = std::filesystem;

namespace {

std::string temporaryFiles() {
    const std::string folder = fs::temp_directory_path();
    return folder.find_first_of(" :;$") == std::string::npos ? folder : "/tmp";
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string &name) {
    std::string path = temporaryFiles() + '/' + name + "_XXXXXX";
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + path);
    m_path = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;  // what cannot be removed stays
    fs::remove_all(m_path, ignored);
}

std::string TemporaryFolder::write(const std::string &name, const std::string &text) const {
    writeTextFile(file(name), text);
    return file(name);
}

void TemporaryFolder::empty() const {
    for (const fs::directory_entry &entry : fs::directory_iterator(m_path)) fs::remove_all(entry.path());
}

}  // namespace support
