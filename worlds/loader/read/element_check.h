// Checks elements as they were written, by the table of elements, and leaves in the tree those alone that are
// read.
#pragma once

#include "loader/description/element.h"
#include "loader/read/reading.h"

#include <functional>

namespace worlds {

// Called for every <include>, in order and once it is checked. Returns the model that takes its place, with
// its name: one, or none.
using OnInclude = std::function<std::list<Element>(Element &include)>;

// `root` is the <sdf> element of a world. Throws LoadError as element_rules.h demands.
void checkElements(Element &root, const Issues &issues, const OnInclude &onInclude);

}  // namespace worlds
