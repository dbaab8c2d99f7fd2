// Runs a program in a process of its own and waits for it.
#pragma once

#include <string>
#include <vector>

#include "process/spawn.h"

namespace exactness {

struct ChildResult {
    bool succeeded;      // ended by itself with exit code 0
    std::string ending;  // "exit code 0", "signal 6 (Aborted)"
    std::string output;  // standard output
    std::string errors;  // standard error, which is a file for the child
};

// `variables` are set on top of this process's environment, or removed where they are empty. Throws std::runtime_error if the program
// cannot be started.
ChildResult runChild(const std::vector<std::string> &command,
                     const process::Environment &variables);

// A folder of its own that goes away with its contents.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    std::string file(const std::string &name) const { return m_path + '/' + name; }

private:
    std::string m_path;
};

}  // namespace exactness
