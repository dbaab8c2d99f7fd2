// A folder of its own among the system's temporary files, which goes away with its contents.
#pragma once

#include <filesystem>
#include <string>

namespace support {

class TemporaryFolder {
public:
    // Its name begins with `name`. Its path has no character that separates paths for the loader of libraries. Throws std::runtime_error.
    explicit TemporaryFolder(const std::string &name = "odemt");
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::filesystem::path &path() const { return m_path; }
    std::string file(const std::string &name) const { return m_path / name; }

    // Writes a file in it, and its folder. Returns its path.
    std::string write(const std::string &name, const std::string &text) const;

    // Removes what is inside.
    void empty() const;

private:
    std::filesystem::path m_path;
};

}  // namespace support
