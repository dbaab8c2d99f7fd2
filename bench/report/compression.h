// Recordings as text that fits into a page: compressed (a sixth), and in letters that HTML leaves alone.
#pragma once

#include <string>

namespace report {

std::string gzip(const std::string &bytes);    // RFC 1952
std::string base64(const std::string &bytes);  // RFC 4648, section 4

}  // namespace report
