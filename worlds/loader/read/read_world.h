// A whole world, from elements to plain data.
#pragma once

#include "loader/description/world_description.h"
#include "loader/read/reading.h"

namespace worlds {

// Takes the <sdf> element of a checked document. Controllers keep it. Throws LoadError.
WorldDescription readWorld(const std::shared_ptr<Element> &document, const Reading &reading);

}  // namespace worlds
