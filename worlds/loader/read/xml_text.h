// Reads XML as the standard has it, and a little beyond: tinyxml2 alone takes much that is not well-formed,
// and ends a text at a character 0.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

namespace worlds {

// Empty, or why `text` is not XML that can be read: not well-formed, not in UTF-8, with a document type, with
// names or lists of attributes beyond all measure. Comments may hold "--", and blanks and comments may
// precede the declaration, as Gazebo reads them: `faults`, if given, is told.
std::string readXml(const std::string &text, tinyxml2::XMLDocument &xml, std::vector<std::string> *faults = nullptr);

// All the text directly inside an element, without the blanks around it; comments and elements part it.
std::string wholeText(const tinyxml2::XMLElement &element);

}  // namespace worlds
