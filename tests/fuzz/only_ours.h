// Functions of ODE_MT's own, which Debian's library does not have: called where they are there.
#pragma once

#include "played_as.h"

#include <dlfcn.h>

namespace fuzz {

// Returns NULL where the library has no such function, or is played as if it had none.
template <class Result, class... Types>
auto functionOfOurs(const char *name) {
    return reinterpret_cast<Result (*)(Types...)>(playedAs.isSerial ? nullptr : dlsym(RTLD_DEFAULT, name));
}

// The result is not recorded: the other library has nothing to compare it with.
template <class... Types>
void callIfThere(const char *name, Types... arguments) {
    if (const auto function = functionOfOurs<int, Types...>(name)) function(arguments...);
}

// For settings of the solver fast, which change results: its runs have them alike, hidden or not.
template <class... Types>
void callOnFast(const char *name, Types... arguments) {
    const auto function = reinterpret_cast<int (*)(Types...)>(dlsym(RTLD_DEFAULT, name));
    if (function != nullptr) function(arguments...);
}

inline bool isOurs() { return functionOfOurs<void, int>("dToggleODE_MT") != nullptr; }

}  // namespace fuzz
