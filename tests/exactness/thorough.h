// How much of their cases tests take, by ODE_MT_EXACTNESS: "thorough", all, where they take a part in turn or few repeats otherwise; "turn0", "turn1"
// or "turn2": a third of the thread settings of each scenario, which all three have together.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

namespace exactness {

inline std::string wantedExactness() {
    const char *const wanted = std::getenv("ODE_MT_EXACTNESS");
    return wanted != nullptr ? wanted : "";
}

inline bool isThorough() { return wantedExactness() == "thorough"; }

// Returns whether it is the turn of a case, by its number.
inline bool isTurnOfCase(std::size_t number) {
    constexpr char kTurn[] = "turn";
    const std::string wanted = wantedExactness();
    if (wanted.rfind(kTurn, 0) != 0) return true;
    return number % 3 == std::strtoul(wanted.c_str() + std::strlen(kTurn), nullptr, 10) % 3;
}

}  // namespace exactness
