// A whole world, from elements to plain data.
#pragma once

#include "loader/description/element.h"
#include "loader/description/world_description.h"
#include "loader/read/reading.h"

namespace worlds {

// Reads <physics> and <gravity> of a world. Requires a world whose elements are checked. Throws LoadError.
Physics readPhysics(const Element &world);

// Takes the <sdf> element of a checked document. Controllers keep it. Throws LoadError.
WorldDescription readWorld(const std::shared_ptr<Element> &document, const Reading &reading);

}  // namespace worlds
