#include "environment/variable_table.h"

#include "support/text.h"

#include <algorithm>
#include <charconv>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace fuzz_environment {

namespace {

bool contains(const std::vector<std::string> &list, const std::string &word) {
    return std::count(list.begin(), list.end(), word) > 0;
}

Variable readRow(const std::smatch &row) {
    Variable variable;
    variable.name = row[1];
    for (const std::string &alternative : support::split(row[2].str() + '|', '|')) {
        if (alternative == "n")
            variable.takesNumber = true;
        else if (alternative == "x")
            variable.takesFraction = true;
        else if (alternative.find("...") != std::string::npos)
            variable.takesList = true;
        else
            variable.words.push_back(alternative);
    }
    std::smatch found;
    const std::string meaning = row[3], standard = row[4];
    if (std::regex_search(meaning, found, std::regex("([0-9]+) to ([0-9]+)"))) {
        variable.least = std::stoll(found[1]);
        variable.most = std::stoll(found[2]);
    }
    std::regex_search(standard, found, std::regex("[a-z0-9]+"));
    variable.standard = found[0];
    return variable;
}

// Decimal digits and nothing else, with a minus in front if it is below the range.
bool isNumber(const std::string &value) {
    const std::size_t begin = value[0] == '-' ? 1 : 0;
    return value.size() > begin && value.find_first_not_of("0123456789", begin) == std::string::npos;
}

bool isFraction(const std::string &value) {
    double number = -1;
    const auto [stopped, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    return error == std::errc() && stopped == value.data() + value.size() && number >= 0 && number <= 1;
}

// -1, 0, 1: whether the number is below, within or above; digits only, of any length.
int compare(const std::string &digits, long long limit) {
    const std::string number = digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1)),
                      other = std::to_string(limit);
    if (number.size() != other.size()) return number.size() < other.size() ? -1 : 1;
    return number.compare(other);
}

Meaning meaningOfNumber(const Variable &variable, const std::string &value) {
    const long long least = variable.least.value_or(0), most = variable.most.value_or(0x7fffffffffffffff);
    if (value[0] == '-') {
        const bool isZero = value.find_first_not_of("-0") == std::string::npos;
        return isZero ? Meaning{Understanding::Untold, ""}
                      : Meaning{Understanding::OutOfRange, std::to_string(least)};
    }
    if (compare(value, least) < 0) return {Understanding::OutOfRange, std::to_string(least)};
    if (compare(value, most) > 0) return {Understanding::OutOfRange, std::to_string(most)};
    return {Understanding::Understood, std::to_string(std::stoll(value))};
}

}  // namespace

std::vector<Variable> readVariableTable(const std::string &document) {
    static const std::regex row(R"(\| `(ODE_MT_[A-Z_]+)=([^`]*)` \|[^|]*\| (.*) \| (.*) \|)");  // the second column: calls
    std::vector<Variable> table;
    std::istringstream lines(document);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        std::string plain;
        std::remove_copy(line.begin(), line.end(), std::back_inserter(plain), '\\');
        // Not workers, which would be processes of their own.
        if (std::regex_match(plain, found, row) && found[1] != "ODE_MT_WORKERS") table.push_back(readRow(found));
    }
    if (table.size() < 8) throw std::runtime_error("docs/settings.md has no table of variables");
    return table;
}

std::vector<std::string> readHeuristicNames(const std::string &document) {
    static const std::regex row(R"(\| `([a-z]+)` \| .* \| (yes|no)( .*)? \|)");
    std::vector<std::string> names;
    std::istringstream lines(document);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (std::regex_match(line, found, row)) names.push_back(found[1]);
    }
    if (names.empty()) throw std::runtime_error("docs/clusters.md has no table of names");
    return names;
}

Meaning meaningOf(const Variable &variable, const std::string &value,
                  const std::vector<std::string> &heuristics) {
    if (value.empty()) return {Understanding::Unset, variable.standard};
    if (variable.name == "ODE_MT_TRACE" || variable.name == "ODE_MT_STATISTICS") return {Understanding::Untold, ""};  // any name of a file
    if (contains(variable.words, value)) return {Understanding::Understood, value};
    if (variable.takesNumber && isNumber(value)) return meaningOfNumber(variable, value);
    if (variable.takesFraction && isFraction(value)) return {Understanding::Understood, value};
    if (variable.takesList) {
        const std::vector<std::string> names = support::split(value + ',', ',');
        const bool areKnown = std::all_of(
            names.begin(), names.end(), [&](const std::string &name) { return contains(heuristics, name); });
        const bool areDistinct = std::set<std::string>(names.begin(), names.end()).size() == names.size();
        if (areKnown) return {areDistinct ? Understanding::Understood : Understanding::Untold, ""};
    }
    return {Understanding::NotUnderstood, variable.standard};
}

}  // namespace fuzz_environment
