// Heights out of a grey image: whatever stb_image reads, PNG with 8 or 16 bits among it.
#pragma once

#include <string>

#include "loader/description/world_description.h"
#include "loader/load_error.h"

namespace worlds {

// Looks through a PNG file before it is decoded: the decoder passes over every checksum.
//
// Returns an empty text for a file that is no PNG; else what is wrong with it: a part or the whole is cut off, a checksum
// does not match, or there are more or fewer pixels than its size says.
std::string whyNotPng(const std::string &bytes);

// Black is height 0 and white is size.z; the image's top edge is at +y. `place` is where the image
// is named. Throws LoadError.
HeightField readHeightImage(const std::string &file, const Vector3 &size,
                            const Place &place);

}  // namespace worlds
