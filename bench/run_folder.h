// A temporary folder for a run of a program, and lists of paths for its loader.
#pragma once

#include <string>

namespace bench {

// A folder of its own that goes away with its contents. Its path has no character that separates paths for the loader.
class RunFolder {
public:
    // Throws std::runtime_error.
    explicit RunFolder(const std::string &nameOfTool);
    ~RunFolder();
    RunFolder(const RunFolder &) = delete;
    RunFolder &operator=(const RunFolder &) = delete;

    const std::string &path() const { return m_path; }

    // Makes a folder in it where a library alone is, so that programs find no others in it than without. Returns its path.
    std::string addLibrary(const std::string &folder, const std::string &library) const;

private:
    std::string m_path;
};

// A variable of the environment that is a list of paths, with one more in front.
std::string inFront(const std::string &path, const char *variable);

}  // namespace bench
