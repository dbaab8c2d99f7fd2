#include "loader/read/source_place.h"

#include "loader/read/element_path.h"

#include <tinyxml2.h>

namespace worlds {

namespace {

using tinyxml2::XMLElement;

// Calls `visit(element, path)` for all elements in the order of the text, until it returns true.
template <class Visit>
bool walk(const XMLElement &element, const std::string &outer, Visit visit) {
    const std::string path = outer + "/" + shownName(element.Name(), element.Attribute("name"));
    if (visit(element, path)) return true;
    for (const XMLElement *child = element.FirstChildElement(); child; child = child->NextSiblingElement())
        if (walk(*child, path, visit)) return true;
    return false;
}

bool names(const XMLElement &element, const std::string &name) {
    for (const tinyxml2::XMLAttribute *at = element.FirstAttribute(); at; at = at->Next())
        if (name == at->Value()) return true;
    return element.GetText() && name == element.GetText();
}

}  // namespace

std::string pathOfLine(const std::string &text, int line) {
    tinyxml2::XMLDocument xml;
    if (line < 1 || xml.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) return {};
    std::string last;
    walk(*xml.RootElement(), "", [&](const XMLElement &element, const std::string &path) {
        if (element.GetLineNum() > line) return true;
        last = path;
        return false;
    });
    return last;
}

std::string pathOfName(const std::string &text, const std::string &name) {
    tinyxml2::XMLDocument xml;
    if (xml.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) return {};
    std::string found;
    walk(*xml.RootElement(), "", [&](const XMLElement &element, const std::string &path) {
        if (!names(element, name)) return false;
        found = path;
        return true;
    });
    return found;
}

std::string includedPath(const std::string &path, const std::string &outerPath,
                         const std::string &givenName) {
    const std::string root = "/sdf/";
    if (path.compare(0, root.size(), root) != 0) return outerPath;
    std::string inside = path.substr(root.size());
    const std::size_t end = inside.find('/');  // a name with a slash is truncated, and the place is still recognised
    if (!givenName.empty())
        inside = shownName("model", givenName.c_str()) + (end == std::string::npos ? "" : inside.substr(end));
    return outerPath + "/" + inside;
}

std::vector<std::string> namesIn(const std::string &message) {
    std::vector<std::string> names, reserved;
    const auto add = [&](std::string name) {
        const std::size_t inner = name.rfind("::");
        if (!name.empty()) (name.compare(0, 2, "__") == 0 ? reserved : names).push_back(name);
        if (inner != std::string::npos && inner + 2 < name.size()) names.push_back(name.substr(inner + 2));
    };
    for (std::size_t begin = message.find('['); begin != std::string::npos;
         begin = message.find('[', begin + 1)) {
        const std::size_t end = message.find(']', begin);
        if (end != std::string::npos) add(message.substr(begin + 1, end - begin - 1));
    }
    const std::string named = " named ";
    if (const std::size_t at = message.find(named); at != std::string::npos) {
        const std::size_t begin = at + named.size();
        add(message.substr(begin, message.find(' ', begin) - begin));
    }
    names.insert(names.end(), reserved.begin(), reserved.end());
    return names;
}

}  // namespace worlds
