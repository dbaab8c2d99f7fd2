#include "loader/read/value_check.h"

#include "loader/description/element.h"
#include "loader/load_error.h"
#include "support/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace worlds {

namespace {

constexpr double smallestNumber = 1e-300;   // a smaller one has no finite inverse
constexpr double shortestDirection = 1e-9;  // its square can be divided by

std::string write(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

std::string trim(const std::string &text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

std::string range(const ElementRule &rule) {
    if (rule.type != Type::Limit) return "between " + write(rule.least) + " and " + write(rule.most);
    const std::string most = std::isinf(rule.most) ? "" : " up to " + write(rule.most);
    return std::isinf(rule.least) ? "a number" + most + ", or infinite" : write(rule.least) + " or more";
}

std::string wrongRange(const ElementRule &rule, double number) {
    if (std::isnan(number)) return "not a number";
    if (number != 0 && std::fabs(number) < smallestNumber)
        return "too small: neither 0 nor " + write(smallestNumber);
    if (number >= rule.least && number <= rule.most) return {};
    const std::string outside = "not " + range(rule);
    if (std::isinf(number) && rule.type != Type::Limit) return "not finite: " + outside;
    if (number < 0 && rule.least >= 0) return "negative: " + outside;
    if (number == 0) return "not positive: " + outside;
    if (rule.least == 0 && rule.most == 1) return "above 1: " + outside;
    return outside;
}

std::string wrongNumbers(const ElementRule &rule, const std::string &text, std::vector<double> &numbers) {
    const std::string shown = support::quote(text);
    if (!readNumbers(text, numbers)) return shown + " is not a number";
    if (static_cast<int>(numbers.size()) != rule.count)
        return shown + " has " + std::to_string(numbers.size()) + " numbers instead of " +
               std::to_string(rule.count);
    for (const double number : numbers) {
        const std::string wrong = wrongRange(rule, number);
        if (!wrong.empty()) return shown + " is " + wrong;
    }
    if ((rule.type == Type::Whole || rule.type == Type::Mask) &&
        text.find_first_not_of("+-0123456789") != std::string::npos)
        return shown + " is not a whole number " + range(rule);
    if (rule.type == Type::Direction && std::hypot(numbers[0], numbers[1], numbers[2]) < shortestDirection)
        return shown + " is no direction: shorter than " + write(shortestDirection);
    return {};
}

std::string wrongPose(const std::string &text, bool isQuaternion) {
    const ElementRule asNumbers{Use::Read,      Type::Numbers, isQuaternion ? 7 : 6,
                                -largestNumber, largestNumber, Often::Once};
    std::vector<double> numbers;
    std::string wrong = wrongNumbers(asNumbers, text, numbers);
    if (!wrong.empty() || !isQuaternion) return wrong;
    const double length = std::hypot(std::hypot(numbers[3], numbers[4]), std::hypot(numbers[5], numbers[6]));
    if (length < 0.99 || length > 1.01) return support::quote(text) + " holds a quaternion whose length is not 1";
    return {};
}

// The number of a mask that is written in hexadecimal digits; none when it is not.
std::optional<unsigned long long> hexadecimal(const std::string &text) {
    if (text.size() < 3 || text.size() > 18 || text[0] != '0' || (text[1] | 0x20) != 'x') return std::nullopt;
    if (text.find_first_not_of("0123456789abcdefABCDEF", 2) != std::string::npos) return std::nullopt;
    return std::stoull(text, nullptr, 16);
}

bool isOneOf(const std::vector<std::string> &words, const std::string &word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

unsigned readMask(const std::string &text) {
    const std::optional<unsigned long long> mask = hexadecimal(text);
    return static_cast<unsigned>(mask ? *mask : std::stoull(text));
}

std::string complaint(const ElementRule &rule, const std::string &whole, bool isQuaternion) {
    if (rule.type == Type::Any || rule.type == Type::Group) return {};
    const std::string text = trim(whole);
    if (text.empty()) return rule.type == Type::Pose ? "" : "is empty";
    std::vector<double> numbers;
    switch (rule.type) {
        case Type::Text:
            if (text.size() > longestText)
                return support::quote(text) + " has " + std::to_string(text.size()) + " characters, more than " +
                       std::to_string(longestText);
            return {};
        case Type::Choice:
            return isOneOf(rule.choices, text) ? "" : support::quote(text) + " is none of " + support::join(rule.choices, ", ");
        case Type::Flag:
            return isOneOf({"true", "false", "1", "0", "True", "False", "TRUE", "FALSE"}, text)
                       ? ""
                       : support::quote(text) + " is neither true nor false";
        case Type::Pose:
            return wrongPose(text, isQuaternion);
        case Type::Mask:
            if (const auto mask = hexadecimal(text))
                return *mask <= rule.most ? "" : support::quote(text) + " is not " + range(rule);
            return wrongNumbers(rule, text, numbers);
        default:
            return wrongNumbers(rule, text, numbers);
    }
}

std::string describe(const ElementRule &rule) {
    switch (rule.type) {
        case Type::Any:
            return "";
        case Type::Group:
            if (rule.needsOneChild) return "exactly one element";
            if (!rule.needsOneOf.empty()) return "elements; needs " + support::join(rule.needsOneOf, " or ");
            return rule.needs.empty() ? "elements" : "elements; needs " + support::join(rule.needs, ", ");
        case Type::Text:
            return "text, up to " + std::to_string(longestText) + " characters";
        case Type::Choice:
            return support::join(rule.choices, ", ");
        case Type::Flag:
            return "true or false";
        case Type::Pose:
            return "x y z roll pitch yaw, or x y z and a quaternion of length 1, up to " +
                   write(largestNumber) + "; empty: zeros";
        case Type::Mask:
            return "a whole number " + range(rule) + ", also as 0x1f";
        case Type::Whole:
            return "a whole number " + range(rule);
        case Type::Limit:
            return std::isinf(rule.least) ? range(rule) : "a number, " + range(rule) + ", or infinite";
        case Type::Direction:
            return "3 numbers " + range(rule) + ", not all 0";
        case Type::Numbers:
            break;
    }
    return (rule.count == 1 ? "a number " : std::to_string(rule.count) + " numbers ") + range(rule);
}

double limitOrNone(double value) { return value < 0 || value >= largestNumber ? std::numeric_limits<double>::infinity() : value; }

}  // namespace worlds
