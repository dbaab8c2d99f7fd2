#include "core/dxEnvironment.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <system_error>

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

}  // namespace

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

dxNumberText dxReadNumber(const char *text, long long least, long long most, long long &number) {
    const char *const end = text + std::strlen(text);
    long long value = 0;
    const auto [stopped, error] = std::from_chars(text, end, value);
    if (stopped != end || error == std::errc::invalid_argument) return dxNumberText::NoNumber;
    if (value == 0 && *text == '-') return dxNumberText::NoNumber;
    if (error == std::errc::result_out_of_range) {
        number = *text == '-' ? least : most;
        return dxNumberText::OutOfRange;
    }
    number = std::clamp(value, least, most);
    return number == value ? dxNumberText::InRange : dxNumberText::OutOfRange;
}
