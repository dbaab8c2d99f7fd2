// Checks the XML of one file, as it was written, by the table of elements: libsdformat reads leniently
// and forgets what it did not use.
#pragma once

#include "loader/load_error.h"

#include <tinyxml2.h>

#include <functional>
#include <string>

namespace worlds {

// Called for every <include> that was found in order. Returns the name of the model that it includes.
using OnInclude = std::function<std::string(tinyxml2::XMLElement &include, const Place &place)>;

// Parses `text` and returns its <sdf> element, which `xml` owns. Throws LoadError when the text is not
// XML, not SDF, or SDF of an unknown version.
tinyxml2::XMLElement &parseSdf(const std::string &text, const std::string &file, tinyxml2::XMLDocument &xml);

// Both check the contents of an element at a place, and remove what is ignored:
// libsdformat would stumble over its faults. They throw LoadError.
void checkSource(tinyxml2::XMLElement &root, const Place &place, const OnInclude &onInclude);

// The <model> of an included file, whose <include> is in `outer` and may give it a name.
void checkIncludedModel(tinyxml2::XMLElement &model, const Place &outer, const std::string &givenName,
                        const OnInclude &onInclude);

}  // namespace worlds
