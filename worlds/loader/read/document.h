// A world's file and all files that it includes, as one tree of elements.
#pragma once

#include "loader/description/element.h"
#include "loader/read/reading.h"

#include <memory>
#include <string>

namespace worlds {

// Returns the <sdf> element, checked: it holds one <world> and only what is read; a file that holds one model alone is
// a world in which the model stands on a plane. In place of every <include> is the model that it includes, with the name,
// pose and so on that the <include> gives it. `file` names the text in messages. Throws LoadError.
std::shared_ptr<Element> readDocument(const std::string &text, const std::string &file,
                                      const Reading &reading);

}  // namespace worlds
