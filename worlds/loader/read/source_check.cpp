#include "loader/read/source_check.h"

#include "loader/read/element_path.h"
#include "loader/read/element_rules.h"
#include "loader/read/value_check.h"
#include "loader/read/xml_text.h"

#include <algorithm>
#include <map>
#include <set>

namespace worlds {

namespace {

using tinyxml2::XMLElement;

[[noreturn]] void fail(const Place &place, const std::string &what) {
    throw LoadError(LoadError::Kind::Value, place, what);
}

// The text directly inside; comments and elements part it.
std::string textOf(const XMLElement &element) {
    std::string text;
    for (const tinyxml2::XMLNode *node = element.FirstChild(); node; node = node->NextSibling())
        if (node->ToText()) text += std::string(node->Value()) + " ";
    return text;
}

bool isBlank(const std::string &text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

bool isInclude(const XMLElement &element) { return std::string(element.Name()) == "include"; }

Place placeOf(const XMLElement &element, const Place &outer) {
    const char *name = element.Attribute("name");
    return {outer.file, outer.path + "/" + shownName(element.Name(), name)};
}

// From version 1.8 on "::" separates the names of nested elements, and may not be within one.
bool partsNames(const XMLElement &sdf) {
    const char *version = sdf.Attribute("version");
    return version && std::string(version) >= "1.8";
}

class SourceCheck {
public:
    SourceCheck(bool partsNames, const OnInclude &onInclude)
        : m_partsNames(partsNames), m_onInclude(onInclude) {}

    void children(XMLElement &parent, const std::string &context, const Place &outer) const {
        std::map<std::string, std::map<std::string, std::string>> names;  // the kind of each, by set of names
        std::set<std::string> written;
        bool hasDefault = false;  // among <physics>
        for (XMLElement *child = parent.FirstChildElement(), *next = nullptr; child; child = next) {
            next = child->NextSiblingElement();
            const Place place = placeOf(*child, outer);
            const std::string path = context + "/" + child->Name();
            const ElementRule *rule = findElementRule(path);
            if (!rule && isInclude(parent))  // libsdformat leaves it aside without a word
                throw LoadError(LoadError::Kind::Unsupported, place, "not supported");
            if (!rule) continue;  // element_check.h names it, once old versions are converted
            if (!written.insert(child->Name()).second && rule->often == Often::Once)
                fail(place, "is written twice");
            element(*child, path, *rule, place);
            std::string name = child->Attribute("name") ? child->Attribute("name") : "";
            std::string kind = child->Name();
            if (isInclude(*child)) {
                name = m_onInclude(*child, place);
                kind = "model";
            }
            if (const char *chosen = child->Attribute("default"); chosen && kind == "physics") {
                const bool isDefault = std::string(chosen) == "true" || std::string(chosen) == "1";
                if (isDefault && hasDefault) fail(place, "is a second default");
                hasDefault = hasDefault || isDefault;
            }
            if (rule->use == Use::Read && !name.empty())
                distinct(names[setOfNames(context, kind)], kind, name, place);
            if (rule->use == Use::NoPhysics && !isSelected(path)) parent.DeleteChild(child);
        }
    }

    void element(XMLElement &element, const std::string &path, const ElementRule &rule,
                 const Place &place) const {
        attributes(element, place);
        if (rule.use == Use::NoPhysics) return;
        names(element, path, place);
        const std::string text = textOf(element);
        if (rule.use == Use::DefaultOnly && isBlank(text) && !element.FirstChildElement())
            fail(place, "is empty");
        if (rule.use == Use::ReadBySelf) return textOrElements(element, place);
        if (rule.type == Type::Group) {
            if (!isBlank(text)) fail(place, "holds text: " + quote(text.substr(0, text.size() - 1)));
            needs(element, rule, place);
            return children(element, elementContext(path), place);
        }
        if (const XMLElement *inner = element.FirstChildElement(); inner && rule.type != Type::Any)
            fail(place, std::string("holds an element, <") + inner->Name() + ">, in place of a value");
        value(element, text, rule, place);
    }

    static void attributes(const XMLElement &element, const Place &place) {
        std::set<std::string> keys;
        for (const tinyxml2::XMLAttribute *at = element.FirstAttribute(); at; at = at->Next()) {
            const std::string key = at->Name(), value = at->Value();
            if (!keys.insert(key).second) fail(place, "has attribute '" + key + "' twice");
            if (value.size() > longestText)
                fail(place, "attribute '" + key + "' has " + std::to_string(value.size()) +
                                " characters, more than " + std::to_string(longestText));
        }
    }

private:
    // Frames of a world share their names with its models: libsdformat gives such frames other names. Within
    // the models of a world it says itself what shares them.
    static std::string setOfNames(const std::string &context, const std::string &kind) {
        return context == "world" && kind == "frame" ? "model" : kind;
    }

    static void distinct(std::map<std::string, std::string> &kinds, const std::string &kind,
                         const std::string &name, const Place &place) {
        const auto [known, isNew] = kinds.emplace(name, kind);
        if (isNew) return;
        if (known->second == kind) fail(place, "a second <" + kind + "> is called " + quote(name));
        fail(place, "a <" + known->second + "> is called " + quote(name) + ", too");
    }

    void names(const XMLElement &element, const std::string &path, const Place &place) const {
        if (const char *name = element.Attribute("name")) {
            if (isBlank(name)) fail(place, "has an empty name");
            if (m_partsNames && std::string(name).find("::") != std::string::npos)
                fail(place, "a name may not hold '::'");
        }
        if (path.find("/odemt:") == std::string::npos)
            return;  // libsdformat knows the attributes of the others
        for (const tinyxml2::XMLAttribute *at = element.FirstAttribute(); at; at = at->Next())
            if (!isKnown(path, at->Name())) fail(place, std::string("has no attribute '") + at->Name() + "'");
    }

    static bool isKnown(const std::string &path, const std::string &attribute) {
        return std::any_of(attributeRules().begin(), attributeRules().end(), [&](const AttributeRule &rule) {
            return rule.path == path && rule.attribute == attribute;
        });
    }

    // An attribute decides whether it may be ignored: element_check.h checks it.
    static bool isSelected(const std::string &path) {
        return std::any_of(attributeRules().begin(), attributeRules().end(),
                           [&](const AttributeRule &rule) { return rule.path == path; });
    }

    // SDF: a pose without numbers is that of the frame that it names.
    static void value(const XMLElement &element, const std::string &text, const ElementRule &rule,
                      const Place &place) {
        const bool isPose = rule.type == Type::Pose;
        if (isPose) poseAttributes(element, place);
        if (isPose && isBlank(text) && (element.Attribute("relative_to") || element.Attribute("frame")))
            return;
        const char *format = isPose ? element.Attribute("rotation_format") : nullptr;
        const std::string wrong = complaint(rule, text, format && std::string(format) == "quat_xyzw");
        if (!wrong.empty()) fail(place, wrong);
    }

    static void poseAttributes(const XMLElement &pose, const Place &place) {
        const auto check = [&](const char *key, const std::string &rule, const std::string &wrong) {
            const char *value = pose.Attribute(key);
            if (value && (" " + rule + " ").find(" " + std::string(value) + " ") == std::string::npos)
                fail(place, std::string("attribute '") + key + "': " + quote(value) + wrong);
        };
        check("rotation_format", "euler_rpy quat_xyzw", " is neither euler_rpy nor quat_xyzw");
        check("degrees", "true false 1 0", " is neither true nor false");
    }

    // Requires either text or elements in an element that may have both.
    static void textOrElements(XMLElement &outer, const Place &place) {
        if (outer.FirstChildElement() && !isBlank(textOf(outer))) fail(place, "holds text beside elements");
        for (XMLElement *child = outer.FirstChildElement(); child;
             child = child->NextSiblingElement()) {
            const Place inner = placeOf(*child, place);
            attributes(*child, inner);
            textOrElements(*child, inner);
        }
    }

    static void needs(const XMLElement &element, const ElementRule &rule, const Place &place) {
        const auto isThere = [&](const std::string &name) {
            return element.FirstChildElement(name.c_str()) != nullptr;
        };
        for (const std::string &name : rule.needs)
            if (!isThere(name)) fail(place, "needs an element <" + name + ">");
        const std::vector<std::string> &some = rule.needsOneOf;
        if (!some.empty() && std::none_of(some.begin(), some.end(), isThere))
            fail(place, "needs an element " + join(some, " or "));
        if (!rule.needsOneChild) return;
        const XMLElement *first = element.FirstChildElement();
        if (!first) fail(place, "holds no element");
        if (const XMLElement *second = first->NextSiblingElement())
            fail(place, std::string("holds two elements, <") + first->Name() + "> and <" + second->Name() +
                            ">, in place of one");
    }

    bool m_partsNames;
    const OnInclude &m_onInclude;
};

// libsdformat reads no others of the <model> of an included file. Those with a colon are of other namespaces.
void checkModelAttributes(const XMLElement &model, const Place &place) {
    static const std::set<std::string> known = {"name", "canonical_link", "placement_frame"};
    for (const tinyxml2::XMLAttribute *at = model.FirstAttribute(); at; at = at->Next())
        if (const std::string key = at->Name(); known.count(key) == 0 && key.find(':') == std::string::npos && key != "xmlns")
            fail(place, "has no attribute '" + key + "'");
}

void checkVersion(const XMLElement &root, const std::string &file) {
    const Place place{file, "/sdf"};
    const char *version = root.Attribute("version");
    if (!version) throw LoadError(LoadError::Kind::Syntax, place, "not SDF: <sdf> has no version");
    const std::vector<std::string> &known = sdfVersions();
    if (std::find(known.begin(), known.end(), version) == known.end())
        throw LoadError(LoadError::Kind::Unsupported, place,
                        "version " + quote(version) + ": not supported; " + known.front() + " to " +
                            known.back() + " are");
}

}  // namespace

XMLElement &parseSdf(const std::string &text, const std::string &file, tinyxml2::XMLDocument &xml) {
    const auto broken = [&](const std::string &what) {
        return LoadError(LoadError::Kind::Syntax, {file, ""}, what);
    };
    if (const std::string wrong = readXml(text, xml); !wrong.empty()) throw broken(wrong);
    XMLElement *root = xml.RootElement();
    if (!root || std::string(root->Name()) != "sdf") throw broken("not SDF: the root element is not <sdf>");
    if (root->NextSiblingElement()) throw broken("not SDF: more than one root element");
    SourceCheck::attributes(*root, {file, "/sdf"});
    checkVersion(*root, file);
    if (const std::string inside = textOf(*root); !isBlank(inside))
        fail({file, "/sdf"}, "holds text: " + quote(inside.substr(0, inside.size() - 1)));
    return *root;
}

void checkSource(XMLElement &root, const Place &place, const OnInclude &onInclude) {
    SourceCheck(partsNames(root), onInclude).children(root, "/sdf", place);
}

void checkIncludedModel(XMLElement &model, const Place &outer, const std::string &givenName,
                        const OnInclude &onInclude) {
    const char *name = givenName.empty() ? model.Attribute("name") : givenName.c_str();
    const Place place{outer.file, outer.path + "/" + shownName("model", name)};
    const bool parts = partsNames(*model.Parent()->ToElement());
    SourceCheck(parts, onInclude).element(model, "world/model", *findElementRule("world/model"), place);
    checkModelAttributes(model, place);
}

}  // namespace worlds
