// The last lines of what a program has printed into a file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace top {

// Of the file's last few KiB, at most `count` lines, none longer than `width`; characters that a terminal would obey are '?'.
std::vector<std::string> tailOf(const std::string &file, std::size_t count, std::size_t width);

}  // namespace top
