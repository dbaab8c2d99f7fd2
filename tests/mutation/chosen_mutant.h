// Included before every source file of a library with mutants (tests/mutation/run).
#pragma once

#include <cstdlib>

// Whether the process has this one: the variable ODE_MT_MUTANT has its number.
inline bool dxMutant(int number) {
    static const int chosen = [] {
        const char *const text = std::getenv("ODE_MT_MUTANT");
        return text != nullptr ? std::atoi(text) : 0;
    }();
    return chosen == number;
}
