#include "loader/read/element_docs.h"

#include "loader/read/element_rules.h"
#include "loader/read/value_check.h"

namespace worlds {

namespace {

std::string holds(const ElementRule &rule) {
    switch (rule.use) {
        case Use::Read:
            return describe(rule);
        case Use::ReadBySelf:
            return "a controller (README.md)";
        case Use::NoPhysics:
            return "left aside";
        case Use::DefaultOnly:
            break;
    }
    return "SDF's default only";
}

std::string code(const std::string &text) { return "`" + text + "`"; }

}  // namespace

std::string elementDocs() {
    std::string text =
        "# Elements\n\n"
        "Made from the table in `loader/read/element_rules.cpp`, by which worlds are checked; a test "
        "compares.\n"
        "Any other element is an error, and so is any other value, text beside elements, and a second "
        "element\n"
        "where one may be. An element that is missing has SDF's default. Versions " +
        sdfVersions().front() + " to " + sdfVersions().back() +
        ".\n\nPaths begin at the innermost world, model, link, joint or collision.\n\n"
        "| Element | Times | Holds |\n|---|---|---|\n";
    for (const NamedRule &named : elementRules())
        text += "| " + code(named.path) + " | " + (named.rule.often == Often::Once ? "0..1" : "0..n") +
                " | " + holds(named.rule) + " |\n";
    text += "\n| Attribute | One of |\n|---|---|\n";
    for (const AttributeRule &rule : attributeRules())
        text += "| " + code(rule.path + " " + rule.attribute) + " | " + join(rule.values, ", ") + " |\n";
    return text;
}

}  // namespace worlds
