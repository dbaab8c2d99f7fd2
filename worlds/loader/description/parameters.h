// An XML element as plain data, for the parts of a world whose elements libsdformat does not know:
// controllers (<plugin>) and the odemt: elements.
#pragma once

#include "loader/load_error.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace worlds {

struct Parameters {
    Place place;
    std::string name;
    std::string text;
    std::map<std::string, std::string> attributes;
    std::vector<Parameters> children;
    double most = std::numeric_limits<double>::infinity();  // of the magnitude of a number that is read

    // Throws LoadError for the first attribute or child that is not listed, and for a second child of a
    // name that is not among `repeated`.
    void expectOnly(const std::vector<std::string> &knownAttributes, const std::vector<std::string> &once,
                    const std::vector<std::string> &repeated = {}) const;

    // Numbers beyond ±limit are refused where they are read, here and inside.
    void limitNumbers(double limit);

    // Null when there is no child of that name.
    const Parameters *child(const std::string &childName) const;
    // The one child of that name; throws when there is none.
    const Parameters &required(const std::string &childName) const;
    // The same for a value: one that has attributes or children is refused.
    const Parameters &requiredValue(const std::string &childName) const;

    const std::string &attribute(const std::string &key) const;
    double attributeNumber(const std::string &key) const;
    double attributeNumber(const std::string &key, double otherwise) const;

    // The text, read as numbers or words parted by white space. Every number is finite.
    std::vector<double> numbers() const;
    // The same, exactly so many.
    std::vector<double> numbers(std::size_t count) const;
    std::vector<double> notNegativeNumbers(std::size_t count) const;
    std::vector<std::string> words() const;
    double number() const;  // exactly one

    // The number in a child's text; `otherwise` when there is no such child.
    double childNumber(const std::string &childName, double otherwise) const;
    // The same, where infinite means "no limit".
    double childLimit(const std::string &childName, double otherwise) const;

    [[noreturn]] void fail(const std::string &what) const;

private:
    bool isWithinMost(const std::vector<double> &numbers) const;
    void expectWithinMost(const std::string &list) const;
};

// Numbers parted by white space; false when a word is none. "inf" and "nan" are numbers.
bool readNumbers(const std::string &text, std::vector<double> &numbers);

}  // namespace worlds
