// A file of results that is whole at every moment: the old text or the new one, never a part of one.
//
// A new text is written into a temporary file beside the old one and then takes its name (rename), so that an
// interrupt, a kill or a full disk leaves the old text. What is no regular file (a pipe, /dev/null) has no
// name to take and is written to directly.
#pragma once

#include <string>
#include <vector>

namespace bench {

// Makes the folder of `file` if there is none, and tries to write there without touching the file itself.
// Throws std::runtime_error with the file and the reason if that is not possible.
void checkWritable(const std::string &file);

// Throws std::runtime_error with the file and the reason; then the old text is still there.
void writeResultFile(const std::string &file, const std::string &text);

// Requires files whose folders exist. Throws std::invalid_argument if two of them, however they are spelled
// (relative, through a symbolic link), are one file.
void checkDistinct(const std::vector<std::string> &files);

}  // namespace bench
