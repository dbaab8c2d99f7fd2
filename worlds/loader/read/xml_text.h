// Reads XML as the standard has it: tinyxml2 alone takes much that is not well-formed, ends a text at a
// character 0, and parts it at comments and CDATA sections, of which readers then see the first part.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace worlds {

// Empty, or why `text` is not XML that can be read: not well-formed, not in UTF-8, with a document type, with
// names or lists of attributes beyond all measure. In `xml` every text is one node then, with CDATA as plain
// text and a blank in place of each comment in it.
std::string readXml(const std::string &text, tinyxml2::XMLDocument &xml);

// All the text directly inside an element, without the blanks around it. Of an element of readXml().
std::string wholeText(const tinyxml2::XMLElement &element);

}  // namespace worlds
