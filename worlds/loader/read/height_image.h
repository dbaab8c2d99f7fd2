// Heights out of a grey image: whatever stb_image reads, PNG with 8 or 16 bits among it.
#pragma once

#include "loader/description/shape.h"
#include "loader/load_error.h"

#include <ignition/math/Vector3.hh>

#include <string>

namespace worlds {

// Black is height 0 and white is size.Z(); the image's top edge is at +y. `place` is where the image
// is named. Throws LoadError.
HeightField readHeightImage(const std::string &file, const ignition::math::Vector3d &size,
                            const Place &place);

}  // namespace worlds
