// Looks at a file before it is opened.
#pragma once

#include <cstdint>
#include <string>

namespace worlds {

// Empty when `file` is a regular file of at most `maxBytes` that may be read; else what it is: "is a
// folder", "is not a regular file" (a FIFO would be waited for, a device has no end), "is empty", the
// system's words.
std::string whyNotReadable(const std::string &file, std::uintmax_t maxBytes);

// False when the system cannot read it.
bool readBytes(const std::string &file, std::string &bytes);

constexpr std::uintmax_t longestTextFile = 256u << 20;  // bytes

// Throws LoadError with the file's name.
std::string readTextFile(const std::string &file);

}  // namespace worlds
