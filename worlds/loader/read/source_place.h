// Finds places in the text of an SDF file: libsdformat reports lines, or only names.
#pragma once

#include <string>
#include <vector>

namespace worlds {

// The path of the element that begins last up to `line`, "/sdf/world/model[m]"; empty for lines below 1.
std::string pathOfLine(const std::string &text, int line);

// The path of the first element that is called `name` or refers to it, by an attribute or its text; empty
// when there is none.
std::string pathOfName(const std::string &text, const std::string &name);

// A path in an included file, "/sdf/model[m]/link", as one in the world: the path around the <include>
// comes first, and the model has the name that it was given, if any.
std::string includedPath(const std::string &path, const std::string &outerPath, const std::string &givenName);

// The names in a message of libsdformat's, which are in [brackets] or after "named"; nested names
// ("a::b") are followed by their last part. Reserved ones ("__model__") come last.
std::vector<std::string> namesIn(const std::string &message);

}  // namespace worlds
