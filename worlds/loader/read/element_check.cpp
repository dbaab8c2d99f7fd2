#include "loader/read/element_check.h"

#include "loader/control/controller.h"
#include "loader/read/element_rules.h"
#include "loader/read/gazebo_plugins.h"
#include "loader/read/value_check.h"
#include "support/text.h"

#include <algorithm>
#include <map>
#include <set>

namespace worlds {

namespace {

// From this version on the frames of a model have different names, whether they are links, joints or models.
constexpr int kSharedNames = 7;
// From this version on "::" separates the names of nested elements, and may not be within one. Before, Gazebo
// wrote nested models as one model with such names.
constexpr int kPartedNames = 8;

// Names of elements that have the same one around them, by set of names: the kind of each.
using Names = std::map<std::string, std::map<std::string, std::string>>;

bool isReserved(const std::string &name) {
    const std::string mark = "__";
    return name == "world" || (name.size() >= 2 * mark.size() && name.compare(0, 2, mark) == 0 &&
                               name.compare(name.size() - 2, 2, mark) == 0);
}

// Attributes with a colon are of other namespaces.
bool isForeign(const std::string &attribute) {
    return attribute == "xmlns" || attribute.find(':') != std::string::npos;
}

class Check {
public:
    Check(const Issues &issues, const OnInclude &onInclude) : m_issues(issues), m_onInclude(onInclude) {}

    void document(Element &root) {
        const std::string path = "/sdf";
        attributes(root, path, *findElementRule(path));
        children(root, path);
    }

private:
    void children(Element &parent, const std::string &context) {
        Names names;
        children(parent, context, names);
    }

    void children(Element &parent, const std::string &context, Names &names) {
        std::set<std::string> written;
        bool hasDefault = false;  // among <physics>
        std::list<Element> left;
        left.swap(parent.children);
        while (!left.empty()) {
            Element &child = left.front();
            const std::string path = context + "/" + child.name;
            const ElementRule *rule = findElementRule(path, child.file().version);
            if (!rule) {
                m_issues.unsupported(child.place());
            } else {
                if (!written.insert(child.name).second && rule->often == Often::Once) {
                    if (!isReadOnce(path)) child.fail("is written twice");
                    m_issues.warn(child.place(), "is written twice: the first one counts, as in Gazebo");
                    left.pop_front();
                    continue;
                }
                if (child.name == "physics" && isTrue(child.attributeOrEmpty("default"))) {
                    if (hasDefault) child.fail("is a second default");
                    hasDefault = true;
                }
                if (child.name == "physics") engine(child);
                if (element(child, path, *rule)) keep(parent, left, context, names);
            }
            left.pop_front();
        }
    }

    // Whatever engine the file is for, what it says of steps and gravity holds for ours.
    void engine(const Element &physics) const {
        const std::string type = physics.attributeOrEmpty("type");
        for (const char *const other : {"bullet", "dart", "simbody", "tpe"})
            if (type == other) m_issues.warn(physics.place(), "type " + support::quote(type) + ": the engine is ODE nevertheless");
    }

    // Whether of several elements the first one counts, as libsdformat has it. Ours may not be doubled, and no file holds
    // two worlds.
    static bool isReadOnce(const std::string &path) {
        return path != "/sdf/world" && path.find("/odemt:") == std::string::npos;
    }

    // Moves the first of `left` to the parent; what an <include> includes, in its place.
    void keep(Element &parent, std::list<Element> &left, const std::string &context, Names &names) {
        Element &child = left.front();
        if (child.name != "include") {
            distinct(child, child.attributeOrEmpty("name"), child.place(), context, names);
            parent.children.splice(parent.children.end(), left, left.begin());
            left.emplace_front();  // in its place, for the caller to remove
            return;
        }
        std::list<Element> included = m_onInclude(child);
        for (Element &model : included) {
            model.parent = &parent;
            if (!model.isMerged)
                distinct(model, model.attributeOrEmpty("name"), child.place(), context, names);
            const std::string path = context + "/model";
            if (!element(model, path, *findElementRule(path, model.file().version), &names)) included.clear();
        }
        parent.children.splice(parent.children.end(), included);
    }

    // Returns false for an element that is left out, as it is not supported or moves nothing. `outerNames`
    // are those that a merged model shares.
    bool element(Element &element, const std::string &path, const ElementRule &rule,
                 Names *outerNames = nullptr) {
        if (element.name == "plugin" && !isController(element, path)) return false;
        if (!attributes(element, path, rule)) return false;
        if (rule.use == Use::NoPhysics) {
            if (!rule.note.empty()) leaveAside(element, rule);
            return false;
        }
        if (rule.use == Use::ReadBySelf) return textOrElements(element), true;
        if (rule.use == Use::DefaultOnly) return defaultOnly(element, rule), false;
        if (rule.type == Type::Group) {
            if (!element.text.empty() && !element.isCData) element.fail("holds text: " + support::quote(element.text));
            needs(element, path, rule);
            const bool wasStatic = m_isStatic;
            if (element.name == "model") m_isStatic = m_isStatic || element.childFlag("static", false);
            if (outerNames && element.isMerged)
                children(element, elementContext(path), *outerNames);
            else
                children(element, elementContext(path));
            m_isStatic = wasStatic;
            return true;
        }
        if (!element.children.empty())
            element.fail("holds an element, <" + element.children.front().name + ">, in place of a value");
        value(element, path, rule);
        return true;
    }

    // Whether a plugin is a controller of ours. Of any other one no program is run: it is left aside when it moves nothing
    // by itself.
    bool isController(const Element &plugin, const std::string &path) const {
        lengths(plugin);
        const std::string &file = plugin.attribute("filename");
        if (path != "world/plugin" && isControllerType(file)) return true;
        switch (pluginEffect(plugin)) {
            case PluginEffect::MovesNothing:
                break;
            case PluginEffect::AwaitsMessages:
                m_issues.warn(plugin.place(), "filename " + support::quote(file) + ": left aside: it moves something only when it is sent "
                                                                          "messages, and nobody sends any here");
                break;
            case PluginEffect::Unknown:
                m_issues.unsupported(plugin.place(), "filename " + support::quote(file) + ", which may move something, none of " +
                                                         support::join(controllerTypes(), ", "));
        }
        return false;
    }

    // False when an attribute makes the element something that is not supported.
    bool attributes(Element &element, const std::string &path, const ElementRule &rule) const {
        lengths(element);
        const std::vector<const AttributeRule *> rules = attributeRulesOf(path);
        for (const AttributeRule *known : rules) {
            const std::string *const value = element.findAttribute(known->attribute);
            if (!value || known->values.empty() ||
                std::find(known->values.begin(), known->values.end(), *value) != known->values.end())
                continue;
            m_issues.unsupported(element.place(), known->attribute + " " + support::quote(*value) + ", none of " +
                                                      support::join(known->values, ", "));
            return false;
        }
        if (rule.use == Use::NoPhysics) return true;
        if (rule.use == Use::Read) onlyKnown(element, path, rule, rules);
        for (const AttributeRule *known : rules)
            if (known->isNeeded) element.attribute(known->attribute);
        if (const std::string *const name = element.findAttribute("name")) nameOf(element, *name);
        return true;
    }

    static void lengths(const Element &element) {
        for (const auto &[key, value] : element.attributes)
            if (value.size() > longestText)
                element.fail("attribute '" + key + "' has " + std::to_string(value.size()) +
                             " characters, more than " + std::to_string(longestText));
    }

    // Removes the attributes that are not read.
    void onlyKnown(Element &element, const std::string &path, const ElementRule &rule,
                   const std::vector<const AttributeRule *> &rules) const {
        const int version = element.file().version;
        const bool isOurs = path.find("/odemt:") != std::string::npos;
        for (std::size_t i = 0; i < element.attributes.size();) {
            const std::string key = element.attributes[i].first;
            const bool isKnown = std::any_of(rules.begin(), rules.end(), [&](const AttributeRule *known) {
                return known->attribute == key && known->since <= version;
            });
            const bool isOfPose = rule.type == Type::Pose &&
                                  (key == "relative_to" || key == "rotation_format" || key == "degrees");
            if (isKnown || isOfPose) {
                ++i;
                continue;
            }
            element.attributes.erase(element.attributes.begin() + static_cast<std::ptrdiff_t>(i));
            if (isForeign(key) && !isOurs) continue;
            if (isOurs) element.fail("has no attribute '" + key + "'");
            m_issues.unsupported(element.place(), "attribute '" + key + "'");
        }
    }

    static void nameOf(const Element &element, const std::string &name) {
        if (name.find_first_not_of(" \t\r\n") == std::string::npos) element.fail("has an empty name");
        if (element.name == "plugin" || element.name == "physics" || element.name == "world") return;
        if (isReserved(name)) element.fail("the name " + support::quote(name) + " is reserved");
        if (element.file().version >= kPartedNames && name.find("::") != std::string::npos)
            element.fail("a name may not hold '::'");
    }

    // Frames of a world share their names with its models.
    static void distinct(const Element &element, const std::string &name, const Place &place,
                         const std::string &context, Names &names) {
        if (name.empty() || element.name == "plugin") return;
        const std::string &kind = element.name;
        const bool isFrame = kind == "frame" || kind == "model" || kind == "link" || kind == "joint";
        const bool isShared = isFrame && (context == "world" || element.file().version >= kSharedNames);
        const auto [known, isNew] = names[isShared ? "frame" : kind].emplace(name, kind);
        if (isNew) return;
        const bool isSame = known->second == kind;
        throw LoadError(LoadError::Kind::Value, place,
                        (isSame ? "a second <" + kind : "a <" + known->second) + "> is called " +
                            support::quote(name) + (isSame ? "" : ", too"));
    }

    void defaultOnly(const Element &element, const ElementRule &rule) const {
        if (element.text.empty() && element.children.empty()) element.fail("is empty");
        std::vector<double> given, usual;
        const bool isFlag = !readNumbers(rule.usual, usual);  // its default is false
        const bool isUsual = isFlag ? element.text == "false" || element.text == "False" ||
                                          element.text == "FALSE" || element.text == "0"
                                    : readNumbers(element.text, given) && given == usual;
        if (isUsual) return;
        if (rule.note.empty())
            m_issues.unsupported(element.place());
        else
            leaveAside(element, rule);
    }

    void leaveAside(const Element &element, const ElementRule &rule) const {
        m_issues.warn(element.place(), "left aside: " + rule.note);
    }

    void value(const Element &element, const std::string &path, const ElementRule &rule) const {
        if (rule.type == Type::Pose) poseAttributes(element);
        ElementRule used = rule;
        // What does not move may be without mass.
        if (m_isStatic && path.rfind("link/inertial/", 0) == 0) used.least = std::min(used.least, 0.0);
        const std::string wrong =
            complaint(used, element.text, element.attributeOrEmpty("rotation_format") == "quat_xyzw");
        if (!wrong.empty()) element.fail(wrong);
    }

    static void poseAttributes(const Element &pose) {
        const auto check = [&](const char *key, const std::string &rule, const std::string &wrong) {
            const std::string *const value = pose.findAttribute(key);
            if (value && (" " + rule + " ").find(" " + *value + " ") == std::string::npos)
                pose.fail(std::string("attribute '") + key + "': " + support::quote(*value) + wrong);
        };
        check("rotation_format", "euler_rpy quat_xyzw", " is neither euler_rpy nor quat_xyzw");
        check("degrees", "true false 1 0", " is neither true nor false");
    }

    // Requires either text or elements in an element that may have both.
    static void textOrElements(const Element &outer) {
        if (!outer.children.empty() && !outer.text.empty()) outer.fail("holds text beside elements");
        for (const Element &child : outer.children) {
            lengths(child);
            textOrElements(child);
        }
    }

    static void needs(const Element &element, const std::string &path, const ElementRule &rule) {
        const auto isThere = [&](const std::string &name) { return element.child(name) != nullptr; };
        for (const std::string &name : rule.needs)
            if (!isThere(name)) element.fail("needs an element <" + name + ">");
        const std::vector<std::string> &some = rule.needsOneOf;
        if (!some.empty() && std::none_of(some.begin(), some.end(), isThere))
            element.fail("needs an element " + support::join(some, " or "));
        if (!rule.needsOneChild) return;
        if (element.children.empty()) element.fail("holds no element");
        const Element *one = nullptr;
        for (const Element &child : element.children) {
            if (!findElementRule(path + "/" + child.name, child.file().version)) continue;  // is no shape that is supported
            if (one) element.fail("holds two elements, <" + one->name + "> and <" + child.name + ">, in place of one");
            one = &child;
        }
    }

    const Issues &m_issues;
    const OnInclude &m_onInclude;
    bool m_isStatic = false;  // the model around, or one around that
};

}  // namespace

void checkElements(Element &root, const Issues &issues, const OnInclude &onInclude) {
    if (!root.child("world")) throw LoadError(LoadError::Kind::Syntax, root.place(), "holds neither a <world> nor one <model>");
    Check(issues, onInclude).document(root);
}

}  // namespace worlds
