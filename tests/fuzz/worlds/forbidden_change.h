// Changes after which a world must not load any more: what is written would mean nothing, or two things.
#pragma once

#include "driver/random.h"
#include "worlds/world_case.h"

#include <cstdint>
#include <optional>
#include <string>

namespace fuzz_worlds {

enum class Forbidden {
    UnknownElement,
    UnknownAttribute,
    Doubled,
    ExtraNumber,
    MissingNumber,
    NotANumber,
    Unit,       // letters behind a number
    Fraction,   // of a whole number
    StrayText,  // beside elements
    UnknownWord,
    Emptied,
    ElementInValue
};
const char *nameOf(Forbidden kind);

// Where and what: applied once more it is the same, as long as the element is there.
struct ForbiddenChange {
    std::string file, path;
    Forbidden kind = Forbidden::UnknownElement;

    std::string text() const;
};

// Nothing when no element of the case can be changed so.
std::optional<ForbiddenChange> drawForbidden(const WorldCase &world, fuzz_driver::Random &random);

// False when the element is not there, or of another kind. `shownName` is what the error has to name last.
bool apply(const ForbiddenChange &change, WorldCase &world, std::string &shownName);

}  // namespace fuzz_worlds
