#include "core/dxEnvironment.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

extern char **environ;

namespace {

struct Variable {
    const char *name;
    const char *values;  // as the documents have them
};

// In the order of dxVariable.
constexpr Variable kVariables[] = {
    {"ODE_MT_THREADS", "n|auto"},
    {"ODE_MT_CALLBACKS", "serial|concurrent|independent"},
    {"ODE_MT_SOLVER", "exact|fast"},
    {"ODE_MT_SOLVER_TOLERANCE", "x"},
    {"ODE_MT_WARM_START", "0|1"},
    {"ODE_MT_LOG", "error|warning|info|debug"},
    {"ODE_MT_TRACE", "file"},
    {"ODE_MT_STATISTICS", "file"},
    {"ODE_MT_THREAD_MANAGER", "pthread|openmp"},
    {"ODE_MT_PERTURB", "n"},
    {"ODE_MT_ALGORITHM", "auto|serial|lcp|original|static|static-unmerged|duplication|decluster"},
    {"ODE_MT_HEURISTICS", "default|none|NAME,NAME..."},
    {"ODE_MT_GRID_CELLS", "n|auto"},
    {"ODE_MT_WORKERS", "none|mpi|mpi:n"},
};

// Variables of the loader of worlds, the build and the tests, which are in the same environment.
constexpr const char *kVariablesOfOthers[] = {"ODE_MT_WORLDS",      "ODE_MT_PRESET",           "ODE_MT_EXACTNESS",        "ODE_MT_MUTANT",
                                              "ODE_MT_LIBRARY_DIR", "ODE_MT_STOCK_LIBRARY_DIR", "ODE_MT_SCENARIO_PROGRAM", "ODE_MT_REACHED"};

constexpr std::size_t kPrefixLength = 7;  // of "ODE_MT_"

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool startsWith(std::string_view name, std::string_view prefix) {
    return name.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), name.begin(), [](char a, char b) { return a == upper(b); });
}

// Returns the number of letters to be inserted, removed or replaced (Levenshtein's distance).
std::size_t editDistance(std::string_view one, std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    for (std::size_t i = 0; i <= other.size(); ++i) row[i] = i;
    for (std::size_t i = 0; i < one.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t k = 0; k < other.size(); ++k) {
            const std::size_t replaced = diagonal + (upper(one[i]) == other[k] ? 0 : 1);
            diagonal = row[k + 1];
            row[k + 1] = std::min({replaced, row[k] + 1, diagonal + 1});
        }
    }
    return row.back();
}

// Returns the library's name that is probably meant; null: none.
const char *nearestVariable(std::string_view name) {
    const char *nearest = nullptr;
    std::size_t least = 4;  // with more letters it is another word
    for (const Variable &variable : kVariables) {
        const std::size_t length = std::strlen(variable.name), distance = editDistance(name, variable.name);
        if (distance >= least || 2 * distance >= length - kPrefixLength) continue;
        least = distance;
        nearest = variable.name;
    }
    return nearest;
}

bool isRead(std::string_view name) {
    return std::any_of(std::begin(kVariables), std::end(kVariables), [&](const Variable &known) { return name == known.name; }) ||
           std::find(std::begin(kVariablesOfOthers), std::end(kVariablesOfOthers), name) != std::end(kVariablesOfOthers);
}

}  // namespace

void dxReportUnknownVariables(void (*report)(const char *name, const char *nearest)) {
    constexpr std::size_t kMaxName = 100;  // longer names are not near any
    for (char **entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string name(*entry, std::strcspn(*entry, "="));
        const bool isOurs = startsWith(name, "ODE_MT_");
        if ((!isOurs && !startsWith(name, "ODEMT_")) || isRead(name)) continue;
        const char *const value = secure_getenv(name.c_str());
        if (value == nullptr || *value == '\0') continue;
        const char *const nearest = name.size() <= kMaxName ? nearestVariable(name) : nullptr;
        if (isOurs || nearest != nullptr) report(name.c_str(), nearest);
    }
}

const char *dxEnvironment(dxVariable variable) {
    const char *value = secure_getenv(kVariables[static_cast<std::size_t>(variable)].name);
    return value != nullptr && *value != '\0' ? value : nullptr;
}

bool dxReadReal(const char *text, double &number) {
    const char *const end = text + std::strlen(text);
    double value = 0;
    const auto [stopped, error] = std::from_chars(text, end, value);
    if (stopped != end || error != std::errc() || !std::isfinite(value)) return false;
    number = value;
    return true;
}

dxNumberText dxReadNumber(const char *text, long long min, long long max, long long &number) {
    const char *const end = text + std::strlen(text);
    long long value = 0;
    const auto [stopped, error] = std::from_chars(text, end, value);
    if (stopped != end || error == std::errc::invalid_argument) return dxNumberText::NoNumber;
    if (value == 0 && *text == '-') return dxNumberText::NoNumber;
    if (error == std::errc::result_out_of_range) {
        number = *text == '-' ? min : max;
        return dxNumberText::OutOfRange;
    }
    number = std::clamp(value, min, max);
    return number == value ? dxNumberText::InRange : dxNumberText::OutOfRange;
}
