#include "loader/description/element.h"
#include "support/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace worlds {

namespace {

bool contains(const std::vector<std::string> &list, const std::string &word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

bool readNumbers(const std::string &text, std::vector<double> &numbers) {
    for (const std::string &word : support::splitAtBlanks(text)) {
        const bool hasPlus = word[0] == '+' && word.size() > 1 && word[1] != '-';
        const char *begin = word.data() + (hasPlus ? 1 : 0), *end = word.data() + word.size();
        double number = 0;
        const auto result = std::from_chars(begin, end, number);
        if (result.ec != std::errc() || result.ptr != end) return false;
        numbers.push_back(number);
    }
    return true;
}

bool isTrue(const std::string &text) {
    return text == "1" || text == "true" || text == "True" || text == "TRUE";
}

Element &Element::add(const std::string &childName) {
    Element &child = children.emplace_back();
    child.name = childName;
    child.parent = this;
    return child;
}

const SourceFile &Element::file() const {
    const Element *at = this;
    while (!at->source) at = at->parent;
    return *at->source;
}

// A file holds one world, and names of physics profiles are not used: both go without their name.
Place Element::place() const {
    Place place{file().name, {}};
    for (const Element *at = this; at; at = at->parent) {
        if (at->isImplied) continue;
        const bool isShownByName = at->name != "world" && at->name != "physics";
        const std::string *const ownName = isShownByName ? at->findAttribute("name") : nullptr;
        place.path = "/" + at->name + (ownName ? "[" + *ownName + "]" : "") + place.path;
    }
    return place;
}

void Element::fail(const std::string &what) const { throw LoadError(LoadError::Kind::Value, place(), what); }

void Element::expectOnly(const std::vector<std::string> &knownAttributes,
                         const std::vector<std::string> &once,
                         const std::vector<std::string> &repeated) const {
    for (const auto &[key, value] : attributes)
        if (!contains(knownAttributes, key)) fail("has no attribute '" + key + "'");
    for (const Element &element : children) {
        if (contains(repeated, element.name)) continue;
        if (!contains(once, element.name)) element.fail("not known here");
        if (child(element.name) != &element) element.fail("is written twice");
    }
}

void Element::limitNumbers(double limit) {
    most = limit;
    for (Element &element : children) element.limitNumbers(limit);
}

// Finite, too.
bool Element::isWithinMost(const std::vector<double> &numbers) const {
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](double number) { return std::isfinite(number) && std::fabs(number) <= most; });
}

// Throws LoadError for the first word that is a number beyond the limit.
void Element::expectWithinMost(const std::string &list) const {
    for (const std::string &word : support::splitAtBlanks(list)) {
        std::vector<double> values;
        if (!readNumbers(word, values) || !(std::fabs(values[0]) > most)) continue;
        std::ostringstream range;
        range << "between -" << most << " and " << most;
        fail("'" + word + "' is not " + range.str());
    }
}

const Element *Element::child(const std::string &childName) const {
    for (const Element &element : children)
        if (element.name == childName) return &element;
    return nullptr;
}

const Element &Element::required(const std::string &childName) const {
    const Element *found = child(childName);
    if (!found) fail("needs an element <" + childName + ">");
    return *found;
}

const Element &Element::requiredValue(const std::string &childName) const {
    const Element &value = required(childName);
    value.expectOnly({}, {});
    return value;
}

const std::string *Element::findAttribute(const std::string &key) const {
    for (const auto &[known, value] : attributes)
        if (known == key) return &value;
    return nullptr;
}

void Element::setAttribute(const std::string &key, const std::string &value) {
    for (auto &[known, current] : attributes)
        if (known == key) {
            current = value;
            return;
        }
    attributes.emplace_back(key, value);
}

std::string Element::attributeOrEmpty(const std::string &key) const {
    const std::string *const found = findAttribute(key);
    return found ? *found : std::string();
}

const std::string &Element::attribute(const std::string &key) const {
    const std::string *const found = findAttribute(key);
    if (!found) fail("needs an attribute '" + key + "'");
    return *found;
}

double Element::attributeNumber(const std::string &key) const {
    std::vector<double> values;
    const std::string &value = attribute(key);
    if (!readNumbers(value, values) || values.size() != 1 || !isWithinMost(values)) {
        expectWithinMost(value);
        fail("attribute '" + key + "' is " + support::quote(value) + ", not a number");
    }
    return values[0];
}

double Element::attributeNumber(const std::string &key, double otherwise) const {
    return findAttribute(key) ? attributeNumber(key) : otherwise;
}

std::vector<double> Element::numbers() const {
    std::vector<double> values;
    if (!readNumbers(text, values) || !isWithinMost(values)) {
        expectWithinMost(text);
        fail(support::quote(text) + " is not a list of numbers");
    }
    return values;
}

std::vector<double> Element::numbers(std::size_t count) const {
    std::vector<double> values = numbers();
    if (values.size() != count)
        fail("has " + std::to_string(values.size()) + " numbers instead of " + std::to_string(count));
    return values;
}

std::vector<double> Element::notNegativeNumbers(std::size_t count) const {
    std::vector<double> values = numbers(count);
    if (std::any_of(values.begin(), values.end(), [](double value) { return value < 0; }))
        fail("has a negative number");
    return values;
}

std::vector<std::string> Element::words() const { return support::splitAtBlanks(text); }

double Element::number() const {
    const std::vector<double> values = numbers();
    if (values.size() != 1) fail(support::quote(text) + " is not one number");
    return values[0];
}

bool Element::isTrue() const { return worlds::isTrue(text); }

bool Element::childFlag(const std::string &childName, bool otherwise) const {
    const Element *found = child(childName);
    return found ? found->isTrue() : otherwise;
}

Vector3 Element::childVector(const std::string &childName, const Vector3 &otherwise) const {
    const Element *const found = child(childName);
    if (!found) return otherwise;
    const std::vector<double> numbers = found->numbers(3);
    return {numbers[0], numbers[1], numbers[2]};
}

std::string Element::childText(const std::string &childName) const {
    const Element *found = child(childName);
    return found ? found->text : std::string();
}

double Element::childNumber(const std::string &childName, double otherwise) const {
    const Element *found = child(childName);
    if (!found) return otherwise;
    found->expectOnly({}, {});
    return found->number();
}

double Element::childLimit(const std::string &childName, double otherwise) const {
    const Element *found = child(childName);
    if (!found) return otherwise;
    found->expectOnly({}, {});
    std::vector<double> values;
    if (!readNumbers(found->text, values) || values.size() != 1 || std::isnan(values[0]))
        found->fail(support::quote(found->text) + " is not one number");
    return values[0];
}

}  // namespace worlds
