// XML as a tree: elements by their paths, and the rule of the loader's table for each.
#pragma once

#include "loader/read/element_rules.h"

#include <tinyxml2.h>

#include <memory>
#include <string>
#include <vector>

namespace fuzz_worlds {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

// Null when the text is not well-formed, or holds no element.
std::unique_ptr<XMLDocument> parseXml(const std::string &text);

std::string printXml(const XMLDocument &xml);

// All elements, outer ones first.
std::vector<XMLElement *> elementsOf(XMLDocument &xml);

// Empty when there is none.
std::string textOf(const XMLElement &element);

// "pose", "link[a]": as the loader's messages name it.
std::string shownName(const XMLElement &element);

// "/sdf/world/model[m]#1/link[a]": with a number for the second, third ... of the same name.
std::string pathOf(const XMLElement &element);

// Null when there is none.
XMLElement *findElement(XMLDocument &xml, const std::string &path);

struct RuledElement {
    XMLElement *element;
    std::string path;                 // in the table: "link/inertial/mass"
    const worlds::ElementRule *rule;  // never null
    bool isInStatic;                  // somewhere within a model that does not move
};

// The elements of a world or of an included model that the loader reads, and those that it hands to a reader
// of their own, with everything inside.
std::vector<RuledElement> ruledElements(XMLDocument &xml);

}  // namespace fuzz_worlds
