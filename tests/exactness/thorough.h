// Whether tests that take a part of their cases in turn, or fewer repeats, are to take all: ODE_MT_EXACTNESS=thorough.
#pragma once

#include <cstdlib>
#include <string>

namespace exactness {

inline bool isThorough() {
    const char *const wanted = std::getenv("ODE_MT_EXACTNESS");
    return wanted != nullptr && wanted == std::string("thorough");
}

}  // namespace exactness
