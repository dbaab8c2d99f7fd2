// Worlds made from the table of elements: the smallest one that contains a rule's element.
#pragma once

#include "loader/read/element_rules.h"

#include <tinyxml2.h>

#include <string>

namespace rule_world {

// The element's place is `path`; what it needs around and inside is there too. Files that it names
// are those of writeFiles().
struct RuleWorld {
    explicit RuleWorld(const worlds::NamedRule &rule);

    std::string text() const;

    // A floor, and a ball upon it.
    void addCompany();

    // With the model in `modelFile` and an <include> of it in the world's text. Null when the element is
    // in no model.
    bool moveModelTo(const std::string &modelFile);

    tinyxml2::XMLDocument xml;
    tinyxml2::XMLElement *element = nullptr;
    std::string path;  // "/sdf/world/model[m]/link[l]"
};

// A value that the rule allows.
std::string sample(const worlds::NamedRule &rule);

// A mesh, an image and a model, as the samples name them.
void writeFiles(const std::string &folder);

}  // namespace rule_world
