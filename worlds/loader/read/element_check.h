// Walks a document before it is used: names what is not supported and which numbers are impossible.
#pragma once

#include "loader/read/issues.h"

#include <sdf/Element.hh>

#include <string>

namespace worlds {

// `root` is the <sdf> element. Throws LoadError as element_rules.h demands.
void checkElements(const sdf::ElementPtr &root, const std::string &worldFile, const Issues &issues);

}  // namespace worlds
