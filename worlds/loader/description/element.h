// An XML element as plain data: what SDF worlds, models and controllers (<plugin>) are read from.
#pragma once

#include "loader/description/geometry.h"
#include "loader/load_error.h"

#include <limits>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace worlds {

// The file that an element is written in, and its version of SDF: 9 for 1.9.
struct SourceFile {
    std::string name;
    int version = 0;
};

struct Element {
    std::string name;
    std::string text;      // directly inside, without the blanks around it; comments and elements part it
    bool isCData = false;  // all the text is in CDATA sections
    std::vector<std::pair<std::string, std::string>> attributes;
    std::list<Element> children;  // stay where they are in memory, for `parent`
    Element *parent = nullptr;
    std::shared_ptr<const SourceFile> source;  // null: the parent's
    bool isImplied = false;  // not written in the file: no place names it
    bool isMerged = false;  // an included model whose contents belong to the model around it
    double most = std::numeric_limits<double>::infinity();  // of the magnitude of a number that is read

    Element() = default;
    Element(const Element &) = delete;  // the children name their parent
    Element &operator=(const Element &) = delete;

    Element &add(const std::string &childName);

    const SourceFile &file() const;
    Place place() const;

    // Throws LoadError for the first attribute or child that is not listed, and for a second child of a
    // name that is not among `repeated`.
    void expectOnly(const std::vector<std::string> &knownAttributes, const std::vector<std::string> &once,
                    const std::vector<std::string> &repeated = {}) const;

    // Numbers beyond ±limit are refused where they are read, here and inside.
    void limitNumbers(double limit);

    // Null when there is no child of that name.
    const Element *child(const std::string &childName) const;
    // The one child of that name; throws when there is none.
    const Element &required(const std::string &childName) const;
    // The same for a value: one that has attributes or children is refused.
    const Element &requiredValue(const std::string &childName) const;

    // Null when there is no attribute of that name.
    const std::string *findAttribute(const std::string &key) const;
    void setAttribute(const std::string &key, const std::string &value);
    // Empty when there is none: in SDF that means the same.
    std::string attributeOrEmpty(const std::string &key) const;
    const std::string &attribute(const std::string &key) const;
    double attributeNumber(const std::string &key) const;
    double attributeNumber(const std::string &key, double otherwise) const;

    // The text, read as numbers or words parted by white space. Every number is finite.
    std::vector<double> numbers() const;
    // The same, exactly `count` numbers.
    std::vector<double> numbers(std::size_t count) const;
    std::vector<double> notNegativeNumbers(std::size_t count) const;
    std::vector<std::string> words() const;
    double number() const;  // exactly one
    bool isTrue() const;    // of a text that is one of SDF's ways to write a flag

    // The number in a child's text; `otherwise` when there is no such child.
    double childNumber(const std::string &childName, double otherwise) const;
    // The same, where infinite means "no limit".
    double childLimit(const std::string &childName, double otherwise) const;
    bool childFlag(const std::string &childName, bool otherwise) const;
    Vector3 childVector(const std::string &childName, const Vector3 &otherwise) const;
    // Empty when there is no such child.
    std::string childText(const std::string &childName) const;

    [[noreturn]] void fail(const std::string &what) const;

private:
    bool isWithinMost(const std::vector<double> &numbers) const;
    void expectWithinMost(const std::string &list) const;
};

// Numbers parted by white space; false when a word is none. "inf" and "nan" are numbers.
bool readNumbers(const std::string &text, std::vector<double> &numbers);

// Whether `text` says yes, in one of SDF's ways to write a flag.
bool isTrue(const std::string &text);

}  // namespace worlds
