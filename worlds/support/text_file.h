// Files that are read and written as a whole.
#pragma once

#include <string>

namespace support {

// Throws std::runtime_error with the file and the reason.
std::string readTextFile(const std::string &file);

// As far as it can be read: of a folder or a process that has just ended, nothing.
std::string readWhatIsThere(const std::string &file);

// Makes the folder of the file, too. Throws std::runtime_error with the file.
void writeTextFile(const std::string &file, const std::string &text);

// Writes to a file descriptor that may take a part of what it is given. False: not all of it was written, and errno says why.
bool writeAll(int file, const std::string &text);

}  // namespace support
