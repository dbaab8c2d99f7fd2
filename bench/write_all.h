// Writing to a file of the system that may take a part of what it is given.
#pragma once

#include <string>

namespace bench {

// False: not all of it was written, and errno says why.
bool writeAll(int file, const std::string &text);

}  // namespace bench
