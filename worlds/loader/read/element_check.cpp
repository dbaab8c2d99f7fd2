#include "loader/read/element_check.h"

#include "loader/read/element_path.h"
#include "loader/read/element_rules.h"
#include "loader/read/value_check.h"

#include <algorithm>

namespace worlds {

namespace {

class Check {
public:
    Check(const std::string &worldFile, const Issues &issues) : m_worldFile(worldFile), m_issues(issues) {}

    void element(const sdf::ElementPtr &element, const std::string &context) const {
        const std::string path = context + "/" + element->GetName();
        const ElementRule *rule = findElementRule(path);
        if (!rule || (rule->use == Use::DefaultOnly && !holdsDefault(element))) {
            m_issues.unsupported(place(element));
            return;
        }
        if (!attributes(element, path) || rule->use == Use::NoPhysics || rule->use == Use::ReadBySelf) return;
        value(element, *rule);
        children(element, elementContext(path));
    }

    void children(const sdf::ElementPtr &element, const std::string &context) const {
        forEachWritten(element, [&](const sdf::ElementPtr &child) { this->element(child, context); });
    }

private:
    Place place(const sdf::ElementPtr &element) const { return placeOf(element, m_worldFile); }

    // False when an attribute makes the element something that is not supported.
    bool attributes(const sdf::ElementPtr &element, const std::string &path) const {
        for (const AttributeRule &rule : attributeRules()) {
            if (rule.path != path || !element->HasAttribute(rule.attribute)) continue;
            const std::string value = element->GetAttribute(rule.attribute)->GetAsString();
            if (std::find(rule.values.begin(), rule.values.end(), value) != rule.values.end()) continue;
            m_issues.unsupported(place(element), rule.attribute + " " + quote(value) + ", none of " + join(rule.values, ", "));
            return false;
        }
        return true;
    }

    // Numbers once more, for those that the conversion from an older version made. Poses were read as
    // written: here their quaternions are gone.
    void value(const sdf::ElementPtr &element, const ElementRule &rule) const {
        const bool isNumber = rule.type == Type::Numbers || rule.type == Type::Direction ||
                              rule.type == Type::Whole || rule.type == Type::Limit;
        if (!isNumber) return;
        const std::string wrong =
            complaint(rule, element->GetValue() ? element->GetValue()->GetAsString() : std::string());
        if (!wrong.empty()) throw LoadError(LoadError::Kind::Value, place(element), wrong);
    }

    static bool holdsDefault(const sdf::ElementPtr &element) {
        const sdf::ParamPtr value = element->GetValue();
        if (!value) return false;
        if (value->GetTypeName() == "bool") {
            bool given = false;
            value->Get(given);
            return given == (value->GetDefaultAsString() == "1");
        }
        std::vector<double> given, usual;
        return readNumbers(value->GetAsString(), given) && readNumbers(value->GetDefaultAsString(), usual) &&
               given == usual;
    }

    const std::string &m_worldFile;
    const Issues &m_issues;
};

}  // namespace

void checkElements(const sdf::ElementPtr &root, const std::string &worldFile, const Issues &issues) {
    const Check check(worldFile, issues);
    if (root->FindElement("world") == nullptr)
        throw LoadError(LoadError::Kind::Syntax, {worldFile, "/sdf"}, "holds no <world>");
    check.children(root, "/sdf");
}

}  // namespace worlds
