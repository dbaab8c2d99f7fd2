// Heights out of a grey image: whatever stb_image reads, PNG with 8 or 16 bits among it.
#pragma once

#include <string>

#include "loader/description/world_description.h"
#include "loader/load_error.h"

namespace worlds {

// Black is height 0 and white is size.z; the image's top edge is at +y. `place` is where the image
// is named. Throws LoadError.
HeightField readHeightImage(const std::string &file, const Vector3 &size,
                            const Place &place);

}  // namespace worlds
