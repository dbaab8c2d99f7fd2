// Looks through a PNG file before it is decoded: the decoder passes over every checksum.
#pragma once

#include <string>

namespace worlds {

// Empty for a file that is no PNG; else what is wrong with it: a part or the whole is cut off, a checksum
// does not match, or there are more or fewer pixels than its size says.
std::string whyNotPng(const std::string &bytes);

}  // namespace worlds
