// Finds the element that an error of libsdformat's is about: the message has only names, which elements in
// many models and files may bear.
#pragma once

#include <sdf/Element.hh>
#include <sdf/ParserConfig.hh>

#include <string>

namespace worlds {

// Returns, for the document with the <sdf> element `root`, whose loading gave `message`, the element that gives the
// same message when it is loaded by itself, as far inside as one does. Of its parts, the first that bears or
// refers to a name in the message.
sdf::ElementPtr findFaultyElement(const sdf::ElementPtr &root, const std::string &message,
                                  const sdf::ParserConfig &config);

}  // namespace worlds
