// Text as a field of a CSV file.
#pragma once

#include <string>

namespace bench {

// RFC 4180: in quotes, quotes doubled, if it holds a comma, a quote or a line break.
std::string csvField(const std::string &text);

}  // namespace bench
