// The table of elements as documentation: the text of ../../elements.md, which a test compares.
#pragma once

#include <string>

namespace worlds {

std::string elementDocs();

}  // namespace worlds
