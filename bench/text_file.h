// Files that are read as a whole.
#pragma once

#include <string>

namespace bench {

// Throws std::runtime_error with the file and the reason.
std::string readTextFile(const std::string &file);

// As far as it can be read: of a folder or a process that has just ended, nothing.
std::string readWhatIsThere(const std::string &file);

}  // namespace bench
