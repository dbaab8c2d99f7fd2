#include "loader/read/element_check.h"

#include "loader/read/element_path.h"
#include "loader/read/element_rules.h"

#include <algorithm>
#include <cmath>

namespace worlds {

namespace {

const char *complaint(Holds holds, double number) {
    if (std::isnan(number)) return "not a number";
    const bool mayBeInfinite = holds == Holds::Limit || holds == Holds::NotNegativeLimit;
    const bool mayBeNegative = holds == Holds::Limit || holds == Holds::Finite;
    if (std::isinf(number) && !mayBeInfinite) return "not finite";
    if (std::fabs(number) > largestNumber && !mayBeInfinite) return "larger than 1e16";
    if (number < 0 && !mayBeNegative) return "negative";
    if (number == 0 && holds == Holds::Positive) return "not positive";
    if (number > 1 && holds == Holds::Share) return "above 1";
    return nullptr;
}

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
        if (rule->holds != Holds::Anything) numbers(element, rule->holds);
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
            m_issues.unsupported(place(element), rule.attribute + " '" + value + "'");
            return false;
        }
        return true;
    }

    void numbers(const sdf::ElementPtr &element, Holds holds) const {
        const std::string text = element->GetValue() ? element->GetValue()->GetAsString() : "";
        std::vector<double> numbers;
        if (!readNumbers(text, numbers) || numbers.empty())
            throw LoadError(LoadError::Kind::Value, place(element), "'" + text + "' is not a number");
        for (const double number : numbers)
            if (const char *wrong = complaint(holds, number))
                throw LoadError(LoadError::Kind::Value, place(element), "'" + text + "' is " + wrong);
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
