#include "loader/read/element_path.h"

namespace worlds {

namespace {

// What libsdformat calls a file that it was given as text.
const std::string textSource = "<data-string>";

// A file holds one world, and names of physics profiles are not used: both go without their name.
bool isShownByName(const std::string &element) { return element != "world" && element != "physics"; }

std::string ownName(const sdf::Element &element) {
    const bool isNamed = element.GetAttributeSet("name");
    const std::string name = isNamed ? element.GetAttribute("name")->GetAsString() : "";
    return shownName(element.GetName(), isNamed ? name.c_str() : nullptr);
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

std::string shownName(const std::string &type, const char *name) {
    return name && isShownByName(type) ? type + "[" + name + "]" : type;
}

// No std::regex is used: it recurses for every character, and a long name overflows the stack.
std::string shortPath(const std::string &xmlPath) {
    static const std::string open = "[@name=\"", close = "\"]";
    std::string path;
    for (std::size_t at = 0; at < xmlPath.size();) {
        const std::size_t begin = xmlPath.find(open, at);
        const std::size_t end = begin == std::string::npos ? begin : xmlPath.find(close, begin + open.size());
        path += xmlPath.substr(at, end == std::string::npos ? end : begin - at);
        if (end == std::string::npos) break;
        const std::string name = xmlPath.substr(begin + open.size(), end - begin - open.size());
        const std::string type = path.substr(path.rfind('/') + 1);
        path += shownName(type, name.c_str()).substr(type.size());
        at = end + close.size();
    }
    return path;
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
