#include "loader/read/element_path.h"

#include <regex>

namespace worlds {

namespace {

// What libsdformat calls a file that it was given as text.
const std::string textSource = "<data-string>";

// A file holds one world, and names of physics profiles are not used: both go without their name.
bool isShownByName(const std::string &element) { return element != "world" && element != "physics"; }

std::string ownName(const sdf::Element &element) {
    const std::string &type = element.GetName();
    if (!isShownByName(type) || !element.GetAttributeSet("name")) return type;
    return type + "[" + element.GetAttribute("name")->GetAsString() + "]";
}

}  // namespace

Place placeOf(const sdf::ElementPtr &element, const std::string &worldFile) {
    Place place;
    for (sdf::ElementPtr at = element; at; at = at->GetParent()) {
        place.path = "/" + ownName(*at) + place.path;
        if (place.file.empty() && at->FilePath() != textSource) place.file = at->FilePath();
    }
    if (place.file.empty()) place.file = worldFile;
    return place;
}

std::string shortPath(const std::string &xmlPath) {
    static const std::regex unnamed(R"re(/(world|physics)\[@name="[^"]*"\])re");
    static const std::regex named(R"re(\[@name="([^"]*)"\])re");
    return std::regex_replace(std::regex_replace(xmlPath, unnamed, "/$1"), named, "[$1]");
}

Parameters toParameters(const sdf::ElementPtr &element, const std::string &worldFile) {
    Parameters parameters;
    parameters.place = placeOf(element, worldFile);
    parameters.name = element->GetName();
    if (element->GetValue()) parameters.text = element->GetValue()->GetAsString();
    for (const sdf::ParamPtr &attribute : element->GetAttributes())
        if (attribute->GetSet()) parameters.attributes[attribute->GetKey()] = attribute->GetAsString();
    forEachWritten(element, [&](const sdf::ElementPtr &child) {
        parameters.children.push_back(toParameters(child, worldFile));
    });
    return parameters;
}

}  // namespace worlds
