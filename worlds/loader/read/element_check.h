// Traverses a document as libsdformat parsed it, old versions converted: names what is not supported
// and checks numbers that a conversion has made. source_check.h has checked what was written.
#pragma once

#include "loader/read/issues.h"

#include <sdf/Element.hh>

#include <string>

namespace worlds {

// `root` is the <sdf> element. Throws LoadError as element_rules.h demands.
void checkElements(const sdf::ElementPtr &root, const std::string &worldFile, const Issues &issues);

}  // namespace worlds
